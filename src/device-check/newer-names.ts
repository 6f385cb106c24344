import type { Feature } from '#core/board-api';

/** An attribute that only a newer firmware has: of an object of the board's module with this name. */
export interface NewerName {
  readonly feature: Feature;
  /** The object's name as a pattern: `display`, any pin. */
  readonly owner: RegExp;
}

const on = (feature: Feature, owner: RegExp): NewerName => ({ feature, owner });
const touch = on('touch-counts', /^pin(\d+|_\w+)$/);
const recording = on('recording', /^microphone$/);
const audio = on('recording', /^audio$/);

/**
 * Names that firmware v2.1.2 lacks and newer ones have.
 * Source: micropython-microbit-v2, the C module tables of v2.1.2 against those of master and branch audio-recording.
 */
export const newerNames: ReadonlyMap<string, NewerName> = new Map([
  ['rotate', on('rotate', /^display$/)],
  ['sound_level_db', on('sound-level-db', /^microphone$/)],
  ['was_touched', touch],
  ['get_touches', touch],
  ['touch_calibrate', touch],
  ['CLAP', on('clap', /^SoundEvent$/)],
  ['record', recording],
  ['record_into', recording],
  ['is_recording', recording],
  ['stop_recording', recording],
  ['set_sensitivity', recording],
  ['SENSITIVITY_LOW', recording],
  ['SENSITIVITY_MEDIUM', recording],
  ['SENSITIVITY_HIGH', recording],
  ['AudioTrack', audio],
  ['AudioRecording', audio],
  ['sound_level', audio],
]);
