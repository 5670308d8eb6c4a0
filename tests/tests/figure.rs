//! What the pictures of modes take from the plug-in.

use idiophone::engine::Settings;

#[test]
fn figures_are_struck_where_the_plug_in_strikes() {
    let position = Settings::DEFAULT.strike_position;
    assert_eq!(xtask::figure::STRIKE_POSITION, position);
}
