/** The Python names that boards offer: those of the micro:bit, or with the Calliope mini's. Named after the first board with them. */
export type BoardApi = 'microbit-v2' | 'calliope-mini-3';

/**
 * Names added after micro:bit firmware v2.1.2: `display.rotate`, `microphone.sound_level_db`,
 * `pin.was_touched`/`get_touches`/`touch_calibrate`, `SoundEvent.CLAP`, and recording with the microphone.
 */
export type Feature = 'rotate' | 'sound-level-db' | 'touch-counts' | 'clap' | 'recording';
