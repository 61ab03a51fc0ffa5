//! Files of the user: dropped, chosen and downloaded.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use eframe::egui::Context;
use eframe::egui::DroppedFileHandle;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, HtmlAnchorElement, HtmlInputElement, Url};

/// Files that have come in: names and contents, and what is wrong with those that could not be read.
type Arrived = (Vec<(PathBuf, Vec<u8>)>, Vec<String>);

/// Files on their way in, which a browser reads while the page goes on.
#[derive(Clone, Default)]
pub(super) struct Inbox {
    arrived: Rc<RefCell<Arrived>>,
}

impl Inbox {
    /// The files that have come since the last call.
    pub(super) fn take(&self) -> Arrived {
        self.arrived.take()
    }

    /// Reads files that were dropped; they come in together.
    pub(super) fn read(&self, dropped: Vec<DroppedFileHandle>, context: &Context) {
        if dropped.is_empty() {
            return;
        }
        let (inbox, context) = (self.clone(), context.clone());
        spawn_local(async move {
            let mut read = Arrived::default();
            for file in dropped {
                let name = name_of(file.path());
                match file.bytes_async().await {
                    Ok(content) => read.0.push((name, content)),
                    Err(error) => read.1.push(format!("cannot read {}: {error}", name.display())),
                }
            }
            inbox.add(read, &context);
        });
    }

    /// Lets the user choose files.
    pub(super) fn choose(&self, context: &Context) {
        let Some(input) = element::<HtmlInputElement>("input") else { return };
        input.set_type("file");
        input.set_multiple(true);
        let (inbox, context, chosen) = (self.clone(), context.clone(), input.clone());
        let read = Closure::once_into_js(move || {
            spawn_local(async move { inbox.add(read_chosen(&chosen).await, &context) });
        });
        input.set_onchange(Some(read.unchecked_ref()));
        input.click();
    }

    fn add(&self, (files, faults): Arrived, context: &Context) {
        let mut arrived = self.arrived.borrow_mut();
        arrived.0.extend(files);
        arrived.1.extend(faults);
        context.request_repaint();
    }
}

async fn read_chosen(input: &HtmlInputElement) -> Arrived {
    let mut read = Arrived::default();
    let Some(list) = input.files() else { return read };
    for file in (0..list.length()).filter_map(|i| list.item(i)) {
        let name = PathBuf::from(file.name());
        match JsFuture::from(file.array_buffer()).await {
            Ok(buffer) => read.0.push((name, js_sys::Uint8Array::new(&buffer).to_vec())),
            Err(error) => read.1.push(format!("cannot read {}: {}", name.display(), super::text_of(&error))),
        }
    }
    read
}

/// Offers a file to the user, as browsers do with downloads.
pub(super) fn download(name: &Path, content: &[u8]) -> Result<(), JsValue> {
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(content));
    let url = Url::create_object_url_with_blob(&Blob::new_with_u8_array_sequence(&parts)?)?;
    let anchor = element::<HtmlAnchorElement>("a").ok_or("there is no page")?;
    anchor.set_href(&url);
    anchor.set_download(&name_of(name).to_string_lossy());
    anchor.click();
    Url::revoke_object_url(&url)
}

/// The name of a file without its folders.
fn name_of(path: &Path) -> PathBuf {
    path.file_name().map_or_else(|| path.to_owned(), PathBuf::from)
}

fn element<T: JsCast>(tag: &str) -> Option<T> {
    super::document()?.create_element(tag).ok()?.dyn_into().ok()
}
