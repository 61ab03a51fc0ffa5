// Triangles with their edges: three corners each, nothing shared, so that edges are drawn by distances to them.

struct View {
    // From the plane, relative to the scene's origin, to clip space.
    scale: vec2<f32>,
    offset: vec2<f32>,
    // Triangles with an angle below this, in degrees, are bad.
    threshold: f32,
    // What colours stand for: 0 the smallest angle, 1 roundness, 2 the region.
    mode: u32,
    // Bit 0: edges; 1: constrained edges inside; 2: those of the boundary; 3: dark ground; 4: the target wants linear
    // colours.
    switches: u32,
    pixels_per_point: f32,
}

@group(0) @binding(0) var<uniform> view: View;

struct Corner {
    @builtin(position) position: vec4<f32>,
    // 1 at the corner of that number, 0 on the edge opposite to it.
    @location(0) nearness: vec3<f32>,
    @location(1) @interpolate(flat) angle: f32,
    @location(2) @interpolate(flat) facts: u32,
}

@vertex
fn corner(
    @builtin(vertex_index) index: u32,
    @location(0) at: vec2<f32>,
    @location(1) angle: f32,
    @location(2) facts: u32,
) -> Corner {
    var out: Corner;
    out.position = vec4<f32>(at * view.scale + view.offset, 0.0, 1.0);
    let number = index % 3u;
    out.nearness = vec3<f32>(f32(number == 0u), f32(number == 1u), f32(number == 2u));
    out.angle = angle;
    out.facts = facts;
    return out;
}

fn ramp(part: f32, dark: bool) -> vec3<f32> {
    let t = clamp(part, 0.0, 1.0);
    if dark {
        return mix(vec3<f32>(0.42, 0.34, 0.14), vec3<f32>(0.10, 0.38, 0.36), t);
    }
    return mix(vec3<f32>(0.99, 0.93, 0.68), vec3<f32>(0.55, 0.83, 0.76), t);
}

fn of_region(number: u32, dark: bool) -> vec3<f32> {
    if number == 0u {
        return select(vec3<f32>(0.93), vec3<f32>(0.20), dark);
    }
    // Steps of the golden ratio around the circle of hues.
    let hue = fract(f32(number) * 0.61803398875) * 6.0;
    let pure = clamp(abs((vec3<f32>(hue) + vec3<f32>(0.0, 4.0, 2.0)) % 6.0 - 3.0) - 1.0, vec3<f32>(0.0), vec3<f32>(1.0));
    return select(mix(vec3<f32>(1.0), pure, 0.45), mix(vec3<f32>(0.12), pure, 0.40), dark);
}

fn to_linear(c: vec3<f32>) -> vec3<f32> {
    return select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c < vec3<f32>(0.04045));
}

@fragment
fn fill(in: Corner) -> @location(0) vec4<f32> {
    let dark = (view.switches & 8u) != 0u;
    var colour: vec3<f32>;
    if view.mode == 2u {
        colour = of_region(in.facts >> 16u, dark);
    } else if view.mode == 1u {
        colour = ramp(f32((in.facts >> 6u) & 1023u) / 1023.0, dark);
    } else {
        colour = ramp(in.angle / 60.0, dark);
    }
    if view.mode != 2u && in.angle < view.threshold {
        colour = select(vec3<f32>(0.90, 0.45, 0.32), vec3<f32>(0.78, 0.29, 0.18), dark);
    }
    // Distances to the three edges, in pixels.
    let slope = fwidth(in.nearness);
    let distance = in.nearness / max(slope, vec3<f32>(1e-20));
    // A triangle less than some pixels high would be all edge.
    let room = 1.0 / max(max(slope.x, slope.y), max(slope.z, 1e-20));
    let plain = select(vec3<f32>(0.45), vec3<f32>(0.50), dark);
    let heavy = select(vec3<f32>(0.52, 0.26, 0.0), vec3<f32>(0.95, 0.77, 0.32), dark);
    let half = 0.5 * view.pixels_per_point;
    for (var i = 0u; i < 3u; i++) {
        if (view.switches & 1u) != 0u {
            let ink = (1.0 - smoothstep(half, half + 0.8, distance[i])) * smoothstep(3.0, 9.0, room) * 0.8;
            colour = mix(colour, plain, ink);
        }
    }
    for (var i = 0u; i < 3u; i++) {
        let inside = (view.switches & 2u) != 0u && ((in.facts >> i) & 1u) != 0u;
        let boundary = (view.switches & 4u) != 0u && ((in.facts >> (i + 3u)) & 1u) != 0u;
        if inside || boundary {
            let ink = 1.0 - smoothstep(2.0 * half, 2.0 * half + 0.8, distance[i]);
            colour = mix(colour, heavy, ink);
        }
    }
    if (view.switches & 16u) != 0u {
        colour = to_linear(colour);
    }
    return vec4<f32>(colour, 1.0);
}
