import type { Clock } from '#core/clock';
import { MEDIUM_SENSITIVITY, Recorder, type RecordingOrder } from './recorder';
import type { Sensors } from './sensors';

/** The events that the microphone distinguishes. */
export type SoundKind = 'quiet' | 'loud' | 'clap';

const HISTORY = 8; // microbit_microphone.c: EVENT_HISTORY_SIZE
const MAX_LEVEL = 255;
/**
 * At or above `loud` it is loud, at or below `quiet` it is quiet: values of the official simulator
 * (micropython-microbit-v2-simulator microphone.ts). CODAL's own, 65 and 85 dB, would be 69 and 175.
 */
const START_THRESHOLDS = { quiet: 75, loud: 150 } as const;
const DB_AT_0 = 52; // codal-microbit-v2: LEVEL_DETECTOR_SPL_8BIT_000_POINT
const DB_AT_255 = 100; // codal-core LevelDetectorSPL.h: LEVEL_DETECTOR_SPL_8BIT_255_POINT
/**
 * A clap is a noise after a silence. It is longer than a click and shorter than a roar. codal-core LevelDetectorSPL.h:
 * at least 20 quiet blocks, then 2 … 13 noisy ones; a block is 128 samples at 11 kHz, 11.6 ms.
 */
const CLAP_MS = { silenceBefore: 232, shortest: 23, longest: 151 } as const;

/**
 * The microphone: loudness 0 … 255, and the events quiet and loud, which alternate (LevelDetectorSPL.cpp): after a
 * loud event only a quiet one can follow, and vice versa. The microphone begins to listen, and its light turns on, when
 * a program first uses it; earlier sounds have no effect.
 */
export class Microphone {
  private used = false;
  private thresholds: { quiet: number; loud: number } = { ...START_THRESHOLDS };
  private state: 'quiet' | 'loud' = 'quiet';
  private latest: SoundKind = 'quiet';
  private readonly were = new Set<SoundKind>();
  private history: SoundKind[] = [];
  private gain: number = MEDIUM_SENSITIVITY;
  /** The present level, 0 … 255; a recording reads it. */
  private level: number;
  private noiseSinceUs: number | null = null;
  private silenceSinceUs: number;
  private readonly recorder: Recorder;

  /** @param knowsClaps whether the firmware has the event clap */
  constructor(
    private readonly clock: Clock,
    private readonly sensors: Sensors,
    private readonly knowsClaps: boolean,
  ) {
    this.level = sensors.get('soundLevel');
    this.silenceSinceUs = clock.nowUs;
    this.recorder = new Recorder(
      clock,
      () => this.level,
      () => this.gain,
    );
    sensors.onSet((id) => {
      if (id === 'soundLevel') this.hear(this.sensors.get('soundLevel'));
    });
  }

  /** True while its light is on: from the first use until a reset, and during a recording. */
  get isListening(): boolean {
    return this.used || this.recorder.isRecording;
  }

  /** Begins to listen; every call of the program that uses the microphone does this first. */
  listen(): void {
    if (this.used) return;
    this.used = true;
    this.compare();
  }

  /** 0 … 255, whole. */
  get soundLevel(): number {
    return Math.trunc(this.level);
  }

  /** The level in dB: 52 … 100. */
  get soundLevelDb(): number {
    return DB_AT_0 + (this.level * (DB_AT_255 - DB_AT_0)) / MAX_LEVEL;
  }

  /** The level from which it counts as loud, and the level down from which it counts as quiet. */
  get threshold(): { readonly quiet: number; readonly loud: number } {
    return this.thresholds;
  }

  /** Sets one threshold, clamped to 0 … 255. A loud one below the quiet one moves the quiet one, and vice versa. */
  setThreshold(kind: 'quiet' | 'loud', level: number): void {
    const within = Math.max(0, Math.min(MAX_LEVEL, level));
    const { quiet, loud } = this.thresholds;
    if (kind === 'loud') this.thresholds = { loud: within, quiet: Math.min(quiet, Math.max(0, within - 1)) };
    else this.thresholds = { quiet: within, loud: Math.max(loud, Math.min(MAX_LEVEL, within + 1)) };
    this.compare();
  }

  /** The last event. */
  get currentEvent(): SoundKind {
    return this.latest;
  }

  /** True if this event occurred since the last call; also clears the list of `takeEvents`. */
  wasEvent(kind: SoundKind): boolean {
    this.history = [];
    return this.were.delete(kind);
  }

  /** The events since the last call, oldest first, at most 8. */
  takeEvents(): readonly SoundKind[] {
    const taken = this.history;
    this.history = [];
    return taken;
  }

  /** Amplification of recordings: 0.2 at the start. */
  setSensitivity(gain: number): void {
    this.recorder.catchUp();
    this.gain = Math.max(0, gain);
  }

  get isRecording(): boolean {
    return this.recorder.isRecording;
  }

  /** Records while time passes, replacing a current recording. */
  record(order: RecordingOrder): void {
    this.recorder.start(order);
  }

  stopRecording(): void {
    this.recorder.stop();
  }

  /** Back to the state after a start: off, no events. The level remains. */
  reset(): void {
    this.recorder.stop();
    this.used = false;
    this.thresholds = { ...START_THRESHOLDS };
    this.state = 'quiet';
    this.latest = 'quiet';
    this.were.clear();
    this.history = [];
    this.gain = MEDIUM_SENSITIVITY;
  }

  private hear(level: number): void {
    this.recorder.catchUp();
    this.level = level;
    this.feelClap();
    this.compare();
  }

  private compare(): void {
    if (!this.used) return;
    const { quiet, loud } = this.thresholds;
    if (this.state === 'quiet' && this.level >= loud) this.note((this.state = 'loud'));
    else if (this.state === 'loud' && this.level <= quiet) this.note((this.state = 'quiet'));
  }

  /** A clap is recognised when it is over. The thresholds of the start separate noise from silence (chosen). */
  private feelClap(): void {
    const { nowUs } = this.clock;
    if (this.noiseSinceUs === null) {
      if (this.level < START_THRESHOLDS.loud) return;
      const silentMs = (nowUs - this.silenceSinceUs) / 1000;
      this.noiseSinceUs = silentMs >= CLAP_MS.silenceBefore ? nowUs : -Infinity;
    } else if (this.level <= START_THRESHOLDS.quiet) {
      const noisyMs = (nowUs - this.noiseSinceUs) / 1000;
      this.noiseSinceUs = null;
      this.silenceSinceUs = nowUs;
      const isClap = noisyMs >= CLAP_MS.shortest && noisyMs <= CLAP_MS.longest;
      if (isClap && this.knowsClaps && this.used) this.note('clap');
    }
  }

  private note(kind: SoundKind): void {
    this.latest = kind;
    this.were.add(kind);
    if (this.history.length < HISTORY) this.history.push(kind);
  }
}
