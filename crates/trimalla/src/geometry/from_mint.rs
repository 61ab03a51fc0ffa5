//! Points and vectors from and to those of `mint`, which mathematics libraries share.

use mint::{IntoMint, Point2, Vector2};

use super::point::{Point, Vector};

macro_rules! same_as {
    ($own:ident, $theirs:ident) => {
        impl From<$theirs<f64>> for $own {
            fn from(given: $theirs<f64>) -> Self {
                Self::new(given.x, given.y)
            }
        }

        impl From<$theirs<f32>> for $own {
            fn from(given: $theirs<f32>) -> Self {
                Self::new(f64::from(given.x), f64::from(given.y))
            }
        }

        impl From<$own> for $theirs<f64> {
            fn from(own: $own) -> Self {
                Self { x: own.x, y: own.y }
            }
        }

        impl IntoMint for $own {
            type MintType = $theirs<f64>;
        }
    };
}

same_as!(Point, Point2);
same_as!(Vector, Vector2);
