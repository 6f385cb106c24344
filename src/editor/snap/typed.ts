import type { Vec } from '#core/geometry';
import { isTap, startOf, endOf } from '../drag';
import { distanceMm, minus, plus, turned, turnedAbout } from '../plane';
import type { Drag, Tool, ToolContext } from '../tools/tool';
import { readingBy } from './figures';
import type { Reading } from './reading';

/** Between two numbers. */
const TIMES = ' × ';

/**
 * The typed text after a key; `null`: the key does not belong to numbers. Begins with a digit or a minus; Tab, x or *
 * leads to the second number.
 */
export function typedText(text: string, key: string): string | null {
  if (/^[\d-]$/u.test(key)) return text + key;
  if (text === '') return null;
  if (key === 'Backspace') return text.endsWith(TIMES) ? text.slice(0, -TIMES.length) : text.slice(0, -1);
  if (key === '.' || key === ',') return text + key;
  if (['Tab', 'x', 'X', '*', '×'].includes(key)) return text.includes(TIMES) ? text : text + TIMES;
  return null;
}

/** The numbers of a typed text, with a point or a comma; those that are not complete are left out. */
export const typedNumbers = (text: string): readonly number[] =>
  text
    .split(TIMES)
    .filter((part) => /\d/u.test(part))
    .map((part) => Number(part.replace(',', '.')))
    .filter((number) => Number.isFinite(number));

/** Rounding to whole mm makes up to this many corrections necessary. */
const CORRECTIONS = 4;

/**
 * The drag that leads to typed numbers: cm of length, of a movement along the drag, of width and height; degrees of a turn.
 * It ends where the tool's own reading shows these numbers, so that it works for every tool.
 *
 * @returns the same drag if it has no reading or no number was typed
 */
export function typedDrag(tool: Tool, given: Drag, context: ToolContext, numbers: readonly number[]): Drag {
  const drag = leaning(tool, given, context);
  const snapped = readingBy(tool, drag, context);
  if (numbers.length === 0 || snapped === null) return given;
  const [, ...way] = drag.path;
  const start = anchorOf(tool, drag, context, snapped);
  const ending = (end: Vec): Drag => ({ ...drag, free: true, path: [start, ...way, end] });
  let end = endOf(drag);
  for (let time = 0; time < CORRECTIONS; time += 1) {
    const reading = readingBy(tool, ending(end), context);
    const step =
      reading && stepTo(reading, snapped, numbers, { end, readingAt: (at) => readingBy(tool, ending(at), context) });
    if (step === null || distanceMm(step, NOWHERE) < NEAR_MM) break;
    end = plus(end, step);
  }
  return ending(end);
}

const NOWHERE: Vec = { x: 0, y: 0 };
const NEAR_MM = 0.01;

/** A drag that has not moved yet is taken to go this far, in mm, so that it has a direction: to the right, and up. */
const LEANS_MM = 100;

function leaning(tool: Tool, drag: Drag, context: ToolContext): Drag {
  if (!isTap(drag)) return drag;
  const start = startOf(drag);
  const y = readingBy(tool, drag, context)?.type === 'size' ? LEANS_MM : 0;
  return { ...drag, path: [start, plus(start, { x: LEANS_MM, y })] };
}

/** The start of the drag without snapping: drawing begins where it has snapped to. */
function anchorOf(tool: Tool, drag: Drag, context: ToolContext, reading: Reading): Vec {
  const start = startOf(drag);
  if (tool.edit(drag, context)?.type !== 'add') return reading.type === 'heading' ? reading.from : start;
  if (reading.type === 'length') return reading.from;
  return reading.type === 'size' ? (reading.from ?? start) : start;
}

/** The end of a drag and the measurement there, and those of another end. */
interface Ending {
  readonly end: Vec;
  readonly readingAt: (end: Vec) => Reading | null;
}

/** The step that the end of the drag has yet to go; `snapped`: the reading of the drag itself, for its direction. */
function stepTo(reading: Reading, snapped: Reading, numbers: readonly number[], ending: Ending): Vec | null {
  const [first = 0, second] = numbers;
  if (reading.type === 'length' && snapped.type === 'length' && snapped.deg !== null) {
    const along = turned({ x: snapped.mm, y: 0 }, snapped.deg);
    const wanted = plus(
      snapped.from,
      second === undefined ? turned({ x: 10 * first, y: 0 }, snapped.deg) : sides(along, first, second),
    );
    return minus(wanted, plus(reading.from, turned({ x: reading.mm, y: 0 }, reading.deg ?? 0)));
  }
  if (reading.type === 'moved' && snapped.type === 'moved')
    return minus(
      second === undefined ? lengthened(snapped.by, 10 * first) : sides(snapped.by, first, second),
      reading.by,
    );
  if (reading.type === 'size')
    return sizeStep(reading, [10 * first, second === undefined ? null : 10 * second], ending);
  if (reading.type === 'turned' && snapped.type === 'turned') {
    const wantedDeg = snapped.byDeg < 0 ? -first : first;
    return minus(turnedAbout(ending.end, reading.about, wantedDeg - reading.byDeg), ending.end);
  }
  if (reading.type === 'heading') return minus(plus(reading.from, turned({ x: LEANS_MM, y: 0 }, first)), ending.end);
  return reading.type === 'place' && second !== undefined ? minus({ x: 10 * first, y: 10 * second }, reading.at) : null;
}

/** Two typed numbers in the quarter into which something goes, in mm. */
const sides = ({ x, y }: Vec, first: number, second: number): Vec => ({
  x: x < 0 ? -10 * first : 10 * first,
  y: y < 0 ? -10 * second : 10 * second,
});

function lengthened(by: Vec, mm: number): Vec {
  const length = distanceMm(by, NOWHERE);
  return length === 0 ? { x: mm, y: 0 } : { x: (by.x / length) * mm, y: (by.y / length) * mm };
}

type Size = Extract<Reading, { type: 'size' }>;

/** Distance by which the end is moved to find its effect on width and height, in mm. */
const TRIAL_MM = 50;

/** The step of the end to a width and a height; a handle that changes only one of them takes the first number. */
function sizeStep(
  size: Size,
  [width, height]: readonly [number, number | null],
  { end, readingAt }: Ending,
): Vec | null {
  const [alongX, alongY] = [readingAt(plus(end, { x: TRIAL_MM, y: 0 })), readingAt(plus(end, { x: 0, y: TRIAL_MM }))];
  if (alongX?.type !== 'size' || alongY?.type !== 'size') return null;
  const change = (side: 'width' | 'height'): Vec => ({
    x: (alongX[side] - size[side]) / TRIAL_MM,
    y: (alongY[side] - size[side]) / TRIAL_MM,
  });
  const [ofWidth, ofHeight] = [change('width'), change('height')];
  const cross = ofWidth.x * ofHeight.y - ofWidth.y * ofHeight.x;
  if (Math.abs(cross) < 0.1) {
    const isWidth = distanceMm(ofWidth, NOWHERE) > 0.1;
    return alone(isWidth ? ofWidth : ofHeight, width - (isWidth ? size.width : size.height));
  }
  const [w, h] = [width - size.width, (height ?? size.height) - size.height];
  return { x: (w * ofHeight.y - h * ofWidth.y) / cross, y: (h * ofWidth.x - w * ofHeight.x) / cross };
}

function alone(change: Vec, mm: number): Vec | null {
  const square = change.x * change.x + change.y * change.y;
  return square < 0.01 ? null : { x: (change.x * mm) / square, y: (change.y * mm) / square };
}
