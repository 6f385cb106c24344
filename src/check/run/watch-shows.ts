import { textBytesOf } from '#board/radio-text';
import type { Rgb } from '#core/rgb';
import type { Lights } from '#simulation/snapshot';
import type { LightColor, LightPlace } from '../task/task';
import type { ReasonCode } from '../result';
import { metAt, OPEN, type Standing, type Watcher } from './watcher';

/** A watcher that waits for something to occur once. */
function once(
  code: ReasonCode,
  params: Readonly<Record<string, string | number>>,
  listen: (come: (timeUs: number) => void) => Omit<Watcher, 'standing' | 'reason'>,
): Watcher {
  let standing: Standing = OPEN;
  const come = (timeUs: number): void => {
    if (standing === OPEN) standing = metAt(timeUs);
  };
  return { ...listen(come), standing: () => standing, reason: () => ({ code, params }) };
}

/** Watches whether the display shows a picture; how brightly does not count. */
export function watchDisplay(image: string): Watcher {
  const wanted = Array.from(image.replaceAll(':', ''), (digit) => digit !== '0');
  return once('display', { image }, (come) => ({
    step: ({ display, nowUs }) => {
      if (wanted.every((lit, place) => (display[place] ?? 0) > 0 === lit)) come(nowUs);
    },
  }));
}

/** Watches the lights of the first robot and its board. */
export function watchLight(which: LightPlace, color: LightColor | null): Watcher {
  return once('light', { which, ...(color !== null && { color }) }, (come) => ({
    step: (run) => {
      if (isLit(run.lights, which, color)) come(run.nowUs);
    },
  }));
}

function isLit({ robot, rgb, lights }: Lights, which: LightPlace, color: LightColor | null): boolean {
  const { left, right } = robot?.leds ?? { left: 0, right: 0 };
  // Of each kind those on the left come first, whether there are two, four or twelve.
  const sides = [robot?.rgb ?? [], robot?.lamps ?? []].map((colors) => ({
    onLeft: colors.slice(0, colors.length / 2),
    onRight: colors.slice(colors.length / 2),
  }));
  const shines = (light: Rgb): boolean => (color === null ? light.some((part) => part > 0) : isColor(light, color));
  const red = color === null || color === 'red';
  const isLeft = (red && left === 1) || sides.some(({ onLeft }) => onLeft.some(shines));
  const isRight = (red && right === 1) || sides.some(({ onRight }) => onRight.some(shines));
  switch (which) {
    case 'left':
      return isLeft;
    case 'right':
      return isRight;
    case 'both':
      return isLeft && isRight;
    case 'any':
      return isLeft || isRight || rgb.some(shines) || lights.some(({ colors }) => colors.some(shines));
  }
}

/** Which of red, green and blue are lit in a colour. */
const PARTS: Readonly<Record<LightColor, readonly [boolean, boolean, boolean]>> = {
  red: [true, false, false],
  green: [false, true, false],
  blue: [false, false, true],
  yellow: [true, true, false],
  cyan: [false, true, true],
  magenta: [true, false, true],
  white: [true, true, true],
};

/** True if a light has this colour. A part is lit if it is at least half as bright as the brightest one. */
function isColor(light: Rgb, color: LightColor): boolean {
  const most = Math.max(...light);
  return most > 0 && PARTS[color].every((lit, place) => 2 * (light[place] ?? 0) >= most === lit);
}

/** A third of a semitone: what a pupil takes for the same tone. */
const SAME_TONE = 0.02;

/** Watches for a tone, or any sound. */
export function watchSound(hz: number | null): Watcher {
  return once('sound', hz === null ? {} : { hz }, (come) => ({
    sound: (event) => {
      if (hz === null) {
        if (event.type === 'effect' || event.type === 'samples' || event.type === 'speech') come(event.timeUs);
        if (event.type === 'tone' && event.hz !== null) come(event.timeUs);
      } else if (event.type === 'tone' && event.hz !== null && Math.abs(event.hz - hz) <= SAME_TONE * hz)
        come(event.timeUs);
    },
  }));
}

/** Watches the program's output for a text, which may arrive in pieces. */
export function watchConsole(text: string): Watcher {
  let tail = '';
  return once('console', { text }, (come) => ({
    print: (piece, timeUs) => {
      tail += piece.replaceAll('\r\n', '\n');
      if (tail.includes(text)) come(timeUs);
      tail = tail.slice(-text.length);
    },
  }));
}

/** Watches the packets that the program sends for a text. */
export function watchRadio(text: string): Watcher {
  return once('radio', { text }, (come) => ({
    radio: ({ timeUs, bytes }) => {
      const words = textBytesOf(bytes) ?? Uint8Array.from(bytes);
      if (new TextDecoder().decode(words).includes(text)) come(timeUs);
    },
  }));
}

/** Watches the data log for this number of rows that have a value in a column. */
export function watchLog(rows: number, column: string): Watcher {
  let count = 0;
  return once('log', { rows, column }, (come) => ({
    log: (event) => {
      if (event.type === 'clear') count = 0;
      if (event.type !== 'row') return;
      const { headings, values } = event;
      if (values.some((cell, place) => cell !== '' && (column === '' || headings[place] === column))) count += 1;
      if (count >= rows) come(event.timeUs);
    },
  }));
}
