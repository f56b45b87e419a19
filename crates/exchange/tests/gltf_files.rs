//! The reader of the `gltf` crate, which validates, finds the relief and the picture in a file.

use gltf::Gltf;
use riverseed::Map;
use riverseed::export::rasters::{Layer, Rasters, Values};
use riverseed::glam::{DVec2, Vec3};
use riverseed_exchange::Form;
use riverseed_exchange::engine::gltf as own;

use crate::maps::{LINKS, file, map, picture};

struct Mesh {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    places: Vec<[f32; 2]>,
    triangles: Vec<u32>,
    image: Vec<u8>,
}

fn read(bytes: &[u8]) -> Mesh {
    let document = Gltf::from_slice(bytes).unwrap();
    let binary = document.blob.as_deref().unwrap();
    let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|_| Some(binary));
    let texture = primitive.material().pbr_metallic_roughness().base_color_texture().unwrap().texture();
    let gltf::image::Source::View { view, mime_type: "image/png" } = texture.source().source() else { panic!() };
    Mesh {
        positions: reader.read_positions().unwrap().collect(),
        normals: reader.read_normals().unwrap().collect(),
        places: reader.read_tex_coords(0).unwrap().into_f32().collect(),
        triangles: reader.read_indices().unwrap().into_u32().collect(),
        image: binary[view.offset()..][..view.length()].to_vec(),
    }
}

fn of(map: &Map, rasters: &Rasters) -> Vec<u8> {
    file(Form::Gltf, map, Some(rasters), Some(&picture(map)))
}

#[test]
fn corners_are_the_relief_with_a_flat_sea() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let mesh = read(&of(&map, &rasters));
        let Values::Words(steps) = rasters.values(Layer::Heights) else { panic!() };
        assert_eq!(mesh.positions.len(), steps.len(), "{link}");
        let half = map.domain().size.as_dvec2() * 0.5;
        for (i, (position, step)) in mesh.positions.iter().zip(steps).enumerate() {
            let cell = DVec2::new((i % rasters.columns) as f64, (i / rasters.columns) as f64) + 0.5;
            let at = (cell * f64::from(rasters.cell_size) - half) * map.scale().metres_a_unit;
            let height = rasters.scale.metres(step).max(0.0);
            let off = [f64::from(position[0]) - at.x, f64::from(position[1]) - height, f64::from(position[2]) - at.y];
            assert!(off.iter().all(|off| off.abs() < 0.01), "{link}: {off:?}");
        }
    }
}

#[test]
fn triangles_face_up_and_cover_the_map() {
    for link in LINKS {
        let map = map(link);
        let rasters = Rasters::new(&map).unwrap();
        let mesh = read(&of(&map, &rasters));
        let corner = |vertex: u32| Vec3::from(mesh.positions[vertex as usize]);
        let mut area = 0.0;
        for triangle in mesh.triangles.chunks(3) {
            let [a, b, c] = [0, 1, 2].map(|i| corner(triangle[i]));
            let twice = (b - a).cross(c - a).y;
            assert!(twice > 0.0, "{link}");
            area += f64::from(twice) * 0.5;
        }
        let pixel = f64::from(rasters.cell_size) * map.scale().metres_a_unit;
        let whole = (rasters.columns - 1) as f64 * (rasters.rows - 1) as f64 * pixel * pixel;
        assert!((area / whole - 1.0).abs() < 1e-4, "{link}");
        assert!(mesh.normals.iter().all(|normal| (Vec3::from(*normal).length() - 1.0).abs() < 1e-4 && normal[1] > 0.0));
    }
}

#[test]
fn picture_lies_where_the_map_lies() {
    let map = map(LINKS[0]);
    let rasters = Rasters::new(&map).unwrap();
    let mesh = read(&of(&map, &rasters));
    assert!(mesh.image.starts_with(b"\x89PNG"));
    // The picture shows as much of the map as its aspect lets it, and its middle is the map's. It ends at its edges.
    let scale = (120.0 / map.domain().size.x).max(80.0 / map.domain().size.y);
    for (place, position) in mesh.places.iter().zip(&mesh.positions) {
        let expected = [position[0] * scale / 120.0, position[2] * scale / 80.0]
            .map(|x| (x / map.scale().metres_a_unit as f32 + 0.5).clamp(0.0, 1.0));
        assert!(place.iter().all(|share| (0.0..=1.0).contains(share)), "{place:?}");
        assert!(
            (place[0] - expected[0]).abs() < 1e-4 && (place[1] - expected[1]).abs() < 1e-4,
            "{place:?} {expected:?}"
        );
    }
}

#[test]
fn large_rasters_are_thinned_and_the_last_corner_stays() {
    let map = map("country=usual&seed=kauri&land=island&attractors=300&aspect=1");
    let rasters = Rasters::with_size(&map, 1500).unwrap();
    let mesh = read(&of(&map, &rasters));
    assert_eq!(mesh.positions.len(), 751 * 751);
    let last = mesh.positions.last().unwrap();
    let border = map.domain().size * 0.5 * map.scale().metres_a_unit as f32;
    let pixel = rasters.cell_size * map.scale().metres_a_unit as f32;
    assert!(
        (last[0] - (border.x - pixel * 0.5)).abs() < 0.1 && (last[2] - (border.y - pixel * 0.5)).abs() < 0.1,
        "{last:?}"
    );
}

#[test]
fn file_says_what_it_is_and_the_same_map_gives_the_same_bytes() {
    let map = map(LINKS[6]);
    let rasters = Rasters::new(&map).unwrap();
    let bytes = of(&map, &rasters);
    assert!(bytes == of(&map, &rasters));
    let sides = [rasters.columns as u32, rasters.rows as u32];
    assert_eq!(own::about(&bytes), Some(own::extras(&rasters.link, sides, [120, 80])));
    assert_eq!(own::about(&bytes[..bytes.len() - 1]), None);
    assert_eq!(own::about(b"glTF"), None);
}
