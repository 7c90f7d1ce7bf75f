//! Boxes, which do not depend on the flavour.

use unisize::Aabb;

#[test]
fn boxes_keep_every_bit() {
    let odd = [f64::NAN, -f64::NAN, f64::INFINITY, -0.0, 5e-324, f64::MAX];
    for a in odd {
        for b in odd {
            let aabb = Aabb::new([a, b, 1.0], [b, 2.0, a]);
            let bytes = postcard::to_stdvec(&aabb).unwrap();
            let read: Aabb<f64, 3> = postcard::from_bytes(&bytes).unwrap();
            assert_eq!(read.mins.map(f64::to_bits), aabb.mins.map(f64::to_bits));
            assert_eq!(read.maxs.map(f64::to_bits), aabb.maxs.map(f64::to_bits));
        }
    }
}

#[test]
fn boxes_are_plain_in_json() {
    let aabb = Aabb::new([0.5_f32, -1.0], [1.5, 0.0]);
    let json = serde_json::to_string(&aabb).unwrap();
    assert_eq!(json, r#"{"mins":[0.5,-1.0],"maxs":[1.5,0.0]}"#);
    assert_eq!(serde_json::from_str::<Aabb<f32, 2>>(&json).unwrap(), aabb);
    assert!(serde_json::from_str::<Aabb<f32, 3>>(&json).is_err());
    assert!(serde_json::from_str::<Aabb<f32, 1>>(&json).is_err());
}
