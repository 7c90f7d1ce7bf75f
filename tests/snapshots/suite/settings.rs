//! Settings by themselves, and in a broad phase that was read.

use super::crowd::Crowd;
use super::{PairFilter, Settings, Stats, UnisizeBroadPhase};

#[test]
fn settings_come_back_and_may_be_left_out() {
    let settings = Settings::default()
        .with_margin(0.1)
        .with_filter(PairFilter::Bodies);
    let bytes = postcard::to_stdvec(&settings).unwrap();
    assert_eq!(postcard::from_bytes(&bytes), Ok(settings));
    let json = serde_json::to_string(&settings).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&json).unwrap(), settings);
    let partial: Settings = serde_json::from_str(r#"{"filter":"Bodies"}"#).unwrap();
    assert_eq!(partial.filter, Some(PairFilter::Bodies));
    assert_eq!(partial.margin, Settings::default().margin);
}

#[test]
fn settings_hold_in_a_broad_phase_that_was_read() {
    let settings = Settings::default().with_margin(0.1);
    let mut crowd = Crowd::new(400, 20.0, 0.1);
    let mut ours = UnisizeBroadPhase::with_settings(settings);
    crowd.update(&mut ours);
    let bytes = postcard::to_stdvec(&ours).unwrap();
    let mut twin: UnisizeBroadPhase = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(*twin.settings(), settings);
    for _ in 0..30 {
        crowd.advance(1);
        crowd.update(&mut twin);
    }
    let stats = twin.stats();
    let bytes = postcard::to_stdvec(&stats).unwrap();
    assert_eq!(postcard::from_bytes::<Stats>(&bytes), Ok(stats));
    assert!(stats.full_searches > ours.stats().full_searches);
}
