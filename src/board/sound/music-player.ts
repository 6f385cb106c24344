import type { Clock } from '#core/clock';
import { readNote, type NoteMemory } from './note';
import type { Pin } from '../wires/pin';
import type { Sound } from './sound';
import type { TickGrid, TickSlot } from '../tick-grid';

const GAP_MS = 10; // modmusic.c: ARTICULATION_MS
const START_TEMPO = { bpm: 120, ticks: 4 } as const; // modmusic.c: DEFAULT_BPM, DEFAULT_TICKS
const START_MEMORY: NoteMemory = { octave: 4, ticks: 4 }; // modmusic.c: DEFAULT_OCTAVE, DEFAULT_DURATION

/** Speed of the music: beats per minute, and ticks (the unit of note lengths) per beat. */
export interface Tempo {
  readonly bpm: number;
  readonly ticks: number;
}

/** Destination and form of played notes. */
export interface PlayOptions {
  /** The pin that carries the tone besides the speaker; `null` for the speaker alone. */
  readonly pin: Pin | null;
  readonly loop: boolean;
  /** Called in the tick in which the notes have ended by themselves. */
  readonly onOver?: () => void;
}

interface Tune {
  readonly onOver?: (() => void) | undefined;
  readonly notes: readonly string[];
  readonly loop: boolean;
  next: number;
  /** The action at that time: silence before the next note, or the next note. */
  then: 'gap' | 'note';
  untilMs: number;
}

/**
 * Notes and pitches in the background, on the speaker and on a pin's wire.
 *
 * It acts on the board's 6 ms tick and compares whole milliseconds (rule M1): at 120 beats a minute a note of four
 * ticks sounds 492 ms and the next one begins 12 ms later. Source: micropython-microbit-v2 modmusic.c.
 */
export class MusicPlayer {
  private readonly slot: TickSlot;
  private tune: Tune | null = null;
  private periodUs: number | null = null;
  private memory = START_MEMORY;
  private currentTempo: Tempo = START_TEMPO;

  constructor(
    private readonly clock: Clock,
    grid: TickGrid,
    private readonly output: Sound,
  ) {
    this.slot = grid.join(() => this.tick());
  }

  /** The tone the speaker makes, in Hz, or `null` in silence. */
  get frequencyHz(): number | null {
    return this.periodUs === null ? null : 1_000_000 / this.periodUs;
  }

  /** True until a tune or a timed pitch has ended; a waiting call waits for it. An endless pitch does not count. */
  get isPlaying(): boolean {
    return this.tune !== null;
  }

  get tempo(): Tempo {
    return this.currentTempo;
  }

  /** Changes the tempo; 0 or nothing leaves a value as it is. Values are 16 bits wide, as on the device. */
  setTempo(tempo: { readonly bpm?: number; readonly ticks?: number }): void {
    const bpm = tempo.bpm ? tempo.bpm & 0xffff : this.currentTempo.bpm;
    const ticks = tempo.ticks ? tempo.ticks & 0xffff : this.currentTempo.ticks;
    this.currentTempo = { bpm, ticks };
  }

  /** Resets tempo, octave and note length to those after a start; the current sound continues. */
  resetTempo(): void {
    this.currentTempo = START_TEMPO;
    this.memory = START_MEMORY;
  }

  /**
   * Plays notes (see `readNote`) in the background from the next tick on, replacing what was playing.
   *
   * @returns `null`, or the device's ValueError if the pin is held
   */
  play(notes: readonly string[], options: PlayOptions): string | null {
    this.memory = START_MEMORY;
    const problem = this.begin(options.pin);
    if (problem !== null) return problem;
    const { loop, onOver } = options;
    this.run({ notes, onOver, loop: loop && notes.length > 0, next: 0, then: 'note', untilMs: this.nowMs });
    return null;
  }

  /**
   * Sounds one pitch at once. Silence and the articulation gap follow its duration, then `isPlaying` ends.
   *
   * @param hz whole Hz, 0 for silence. Less than 0, or more than 1 MHz, is no error on the device: the period becomes
   *   0 µs (the argument is unsigned), and the pin stays with the music. The resulting sound is not known; chosen:
   *   silence
   * @param durationMs negative: until something else is played, or a stop
   * @returns `null`, or the device's ValueError if the pin is reserved
   */
  pitch(hz: number, durationMs: number, pin: Pin | null): string | null {
    const problem = this.begin(pin);
    if (problem !== null) return problem;
    if (hz === 0) this.output.route.free();
    else if (hz > 0 && hz <= 1_000_000) this.sound(Math.floor(1_000_000 / hz));
    if (durationMs >= 0) {
      this.run({ notes: [], loop: false, next: 0, then: 'gap', untilMs: this.nowMs + durationMs });
    }
    return null;
  }

  /** Silences at once; the pin is free again. */
  stop(): void {
    this.tune = null;
    this.sound(null);
    this.output.route.free();
  }

  private get nowMs(): number {
    return Math.floor(this.clock.nowUs / 1000);
  }

  private begin(pin: Pin | null): string | null {
    this.stop();
    return this.output.route.select(pin, 'music');
  }

  private run(tune: Tune): void {
    this.tune = tune;
    this.slot.wake();
  }

  private sound(periodUs: number | null): void {
    const changed = periodUs !== this.periodUs;
    this.periodUs = periodUs;
    this.output.route.playTone(periodUs);
    if (changed) this.output.tell({ type: 'tone', hz: this.frequencyHz });
  }

  private tick(): boolean {
    const tune = this.tune;
    if (tune && this.nowMs >= tune.untilMs) this.turn(tune);
    return this.tune !== null;
  }

  private turn(tune: Tune): void {
    if (tune.then === 'gap') {
      this.sound(null);
      tune.untilMs = this.nowMs + GAP_MS;
      tune.then = 'note';
      return;
    }
    if (tune.loop && tune.next >= tune.notes.length) tune.next = 0;
    const text = tune.notes[tune.next];
    if (text === undefined) {
      this.stop();
      tune.onOver?.();
      return;
    }
    const note = readNote(text, this.memory);
    this.memory = note.memory;
    this.sound(note.periodUs);
    tune.next++;
    tune.untilMs = this.nowMs + Math.max(GAP_MS, this.msPerTick * note.memory.ticks - GAP_MS);
    tune.then = 'gap';
  }

  /** Whole ms, divided in the device's order; there, a division by zero gives 0. */
  private get msPerTick(): number {
    const { bpm, ticks } = this.currentTempo;
    if (bpm === 0 || ticks === 0) return 0;
    return Math.floor(Math.floor(60_000 / bpm) / ticks);
  }
}
