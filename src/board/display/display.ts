import { glyphOf } from './glyph';
import { busyMessage, type Pin } from '../wires/pin';
import { scrollFilm, type Film } from './scroll-text';
import type { TickGrid, TickSlot } from '../tick-grid';

const SIDE = 5;
const TICK_MS = 6; // drv_display.c: MILLISECONDS_PER_MACRO_TICK
const DARK = new Uint8Array(SIDE * SIDE);

/** Timing of a sequence of pictures. */
export interface ShowOptions {
  /** Duration of each picture, in ms; rounded up to whole ticks of 6 ms. Negative: for ever, as on the device. */
  readonly delayMs: number;
  /** True: begins again after the last one, without end. */
  readonly loop: boolean;
  /** True: a blank picture follows, for one more delay. */
  readonly clear: boolean;
  /** Called in the tick in which the animation ends by itself, and not when another one replaces it. */
  readonly onOver?: () => void;
}

/** Speed and form of a scrolling text. */
export interface ScrollOptions {
  /** Time for one column, in ms; rounded up to whole ticks of 6 ms. */
  readonly delayMs: number;
  readonly loop: boolean;
  /** True: every letter is five columns wide. */
  readonly monospace: boolean;
}

interface Animation {
  readonly film: Film;
  readonly loop: boolean;
  /** True if a blank picture still has to follow. */
  clear: boolean;
  readonly delayMs: number;
  readonly onOver: (() => void) | undefined;
  next: number;
  waitedMs: number;
}

/**
 * The 5 × 5 LEDs and their animation. The animation advances on the board's 6 ms tick (rule D1); a new `show`,
 * `showFrames`, `scroll` or `clear` ends the previous one. Source: micropython-microbit-v2 drv_display.c.
 */
export class Display {
  private readonly image = new Uint8Array(SIDE * SIDE);
  private readonly slot: TickSlot;
  private animation: Animation | null = null;
  private clearing = false;
  private enabled = true;
  private darkened = false;
  private quarterTurns = 0;

  /** @param pins the pins that the LED columns share */
  constructor(
    grid: TickGrid,
    private readonly pins: readonly Pin[],
  ) {
    this.slot = grid.join(() => this.tick());
  }

  /** The LEDs, 0 … 9, row by row; dark while the display is off or the board sleeps. Read-only. */
  get pixels(): Uint8Array {
    if (!this.enabled || this.darkened) return DARK;
    return this.quarterTurns === 0 ? this.image : turned(this.image, this.quarterTurns);
  }

  /**
   * Turns what is shown from now on; `setPixel` and `getPixel` turn with it.
   *
   * @param quarterTurns counter-clockwise, as the picture moves: upright again on a board that was turned clockwise
   */
  rotate(quarterTurns: number): void {
    this.quarterTurns = quarterTurns & 3;
  }

  get isOn(): boolean {
    return this.enabled;
  }

  /** True until an animation (or a `clear`) has ended. A waiting call waits for it. */
  get isAnimating(): boolean {
    return this.animation !== null || this.clearing;
  }

  /** Takes the display's pins back. @returns `null`, or the device's ValueError if one of them is held */
  on(): string | null {
    for (const pin of this.pins) {
      const holder = pin.acquire('display');
      if (holder) return busyMessage(pin, holder);
    }
    this.stopAnimation();
    this.enabled = true;
    return null;
  }

  /** Darkens the LEDs and gives their pins to the program. */
  off(): void {
    this.enabled = false;
    for (const pin of this.pins) pin.free();
  }

  /** Cuts the LEDs' power while the board sleeps; the picture is retained. */
  darken(isDark: boolean): void {
    this.darkened = isDark;
  }

  /** Sets one LED; an animation continues. @throws RangeError "index out of bounds" or "brightness out of bounds" */
  setPixel(x: number, y: number, brightness: number): void {
    if (!(brightness >= 0 && brightness <= 9)) throw new RangeError('brightness out of bounds');
    this.image[placeOf(x, y)] = brightness;
  }

  /** The brightness set for one LED, also while the display is off. @throws RangeError "index out of bounds" */
  getPixel(x: number, y: number): number {
    return this.image[placeOf(x, y)] ?? 0;
  }

  /** Blanks the pixels at once; an animation continues. */
  blank(): void {
    this.image.fill(0);
  }

  /** Blanks the display at the next tick; `isAnimating` until then. */
  clear(): void {
    this.animation = null;
    this.clearing = true;
    this.slot.wake();
  }

  /** Shows one picture at once, without an end. */
  show(frame: Uint8Array): void {
    this.stopAnimation();
    this.draw(frame);
  }

  /**
   * Shows pictures one after the other, the first at once. The last stays for its delay like the others, and longer if
   * nothing else follows. Without pictures nothing happens, or `clear` shows its blank one. The pictures are copied.
   */
  showFrames(frames: readonly Uint8Array[], options: ShowOptions): void {
    const copies = frames.map((frame) => frame.slice());
    this.run({ length: copies.length, frameAt: (place) => copies[place] ?? DARK }, options);
  }

  /** The same with pictures that are made when they are due. */
  showFilm(film: Film, options: ShowOptions): void {
    this.run(film, options);
  }

  /** Runs a text through the display from the right; the text has left when the animation ends. */
  scroll(text: string, options: ScrollOptions): void {
    this.run(scrollFilm(text, options.monospace), { delayMs: options.delayMs, loop: options.loop, clear: false });
  }

  /** The picture of one character, 25 brightnesses 0 or 9; that of `?` for a character beyond ASCII. */
  glyph(char: string): Uint8Array {
    return glyphOf(char);
  }

  /** Back to the state after a start: on, dark, nothing moves. The pins must have been reset before. */
  reset(): void {
    this.stopAnimation();
    this.image.fill(0);
    this.enabled = true;
    this.quarterTurns = 0;
  }

  /** Ends an animation where it is. */
  stopAnimation(): void {
    this.animation = null;
    this.clearing = false;
  }

  private run(film: Film, options: ShowOptions): void {
    this.stopAnimation();
    const loop = options.loop && film.length > 0;
    const delayMs = options.delayMs >>> 0; // unsigned, as on the device: a negative delay becomes an enormous one
    const { clear, onOver } = options;
    const animation: Animation = { film, loop, clear, delayMs, onOver, next: 0, waitedMs: 0 };
    if (!this.advance(animation)) return;
    this.animation = animation;
    this.slot.wake();
  }

  private tick(): boolean {
    if (this.clearing) {
      this.clearing = false;
      this.image.fill(0);
    }
    const animation = this.animation;
    if (!animation) return false;
    animation.waitedMs += TICK_MS;
    if (animation.waitedMs >= animation.delayMs) {
      animation.waitedMs = 0;
      if (!this.advance(animation)) {
        this.animation = null;
        animation.onOver?.();
      }
    }
    return this.animation !== null;
  }

  /** Draws the next picture; returns false if there is no next one. */
  private advance(animation: Animation): boolean {
    if (animation.loop && animation.next >= animation.film.length) animation.next = 0;
    if (animation.next < animation.film.length) {
      this.draw(animation.film.frameAt(animation.next++));
    } else if (animation.clear) {
      animation.clear = false;
      this.image.fill(0);
    } else {
      return false;
    }
    return true;
  }

  private draw(frame: Uint8Array): void {
    this.image.fill(0);
    this.image.set(frame.subarray(0, SIDE * SIDE));
  }
}

function placeOf(x: number, y: number): number {
  if (!(x >= 0 && x < SIDE && y >= 0 && y < SIDE)) throw new RangeError('index out of bounds');
  return y * SIDE + x;
}

/** The picture after this many quarter turns: its top row becomes the left column (codal-nrf52 NRF52LedMatrix.cpp). */
function turned(image: Uint8Array, quarterTurns: number): Uint8Array {
  let from = image;
  for (let turn = 0; turn < quarterTurns; turn++) {
    const before = from;
    from = before.map((_, place) => {
      const [x, y] = [place % SIDE, Math.floor(place / SIDE)];
      return before[x * SIDE + SIDE - 1 - y] ?? 0;
    });
  }
  return from;
}
