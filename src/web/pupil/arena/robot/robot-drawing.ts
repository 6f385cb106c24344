import { elementsOf, readSvgTree, type SvgElement } from '../picture/svg-tree';

/**
 * Reads a robot.svg: finds its lights, wheels, display and bumper, so that they can be animated.
 *
 * Rules for a robot.svg: 1 unit = 1 mm; seen from above, front up (x = to the right, y = backward), origin in the
 * middle of the axle; `viewBox` around everything. It shows the robot at rest with all lights off. Parts are found by
 * their `id`, either of the shape itself or of a group around it (of circles, the one of class `lit` counts, otherwise
 * the first without class `glow`); they must not be in a transformed group:
 * - `wheel-left`, `wheel-right`: a `<rect>`, the tyre. A moving tread replaces the parts of class `tread` in it.
 * - `rgb-0` … : a `<circle>` per colour light, any number, in the order of the robot's state. It only marks a place and
 *   is not drawn. Under the body: its light falls on the floor around it, from the circle up to 1.75 times as far. With
 *   the class `top` the light is on top of the body: it fills the circle and shines three times as far.
 * - `led-left`, `led-right`: a `<circle>` per red light.
 * - `lamp-left`, `lamp-right`: a `<circle>` per colour lamp, drawn unlit as the red lights are.
 * - `line-NAME`: a `<circle>` per line sensor's light, NAME as in the robot's state.
 * - `display`: a group of 25 `<rect>`, row by row.
 * - `bumper`: a group with two groups `bumper-left` and `bumper-right`. Drawn below everything else, and only while the
 *   robot carries its bumper; a pressed half moves 3 mm towards the axle and turns red.
 * - `ultrasonic`: the group of the distance sensor, which a servo may turn: see `attachment-parts.ts`.
 *
 * What can be plugged in is a group that names its option first (`<g data-if="ultrasonic=yes" id=…`, `data-unless`); it is
 * gone from the text before it comes here: see `drawings.ts` of the robots.
 *
 * A missing part is not animated; nothing else depends on it.
 */
export interface RobotDrawing {
  /** The text without the parts that only mark a place, and without the treads and the bumper. */
  readonly svg: string;
  /** In drawing units (mm). */
  readonly viewBox: Box;
  readonly wheels: { readonly left: Box | null; readonly right: Box | null };
  readonly rgb: readonly ColourLight[];
  readonly leds: { readonly left: Spot | null; readonly right: Spot | null };
  /** Colour lamps. */
  readonly lamps: { readonly left: Spot | null; readonly right: Spot | null };
  /** By the name of the sensor. */
  readonly line: ReadonlyMap<string, Spot>;
  /** The lights of the display, row by row; empty without a display. */
  readonly display: readonly Box[];
  /** A document with each half of the bumper alone. */
  readonly bumper: { readonly left: string; readonly right: string } | null;
}

export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Spot {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** A colour light: under the body, where only its light on the floor is seen, or on top of it. */
export interface ColourLight extends Spot {
  readonly isOnTop: boolean;
}

/** Reads the text of a robot.svg; without a readable `viewBox` 160 × 160 mm around the axle is assumed. */
export function readRobotDrawing(svg: string): RobotDrawing {
  const all = [...elementsOf(readSvgTree(svg))];
  const parts = new Map(all.map((element) => [element.attributes['id'] ?? '', element]));
  const wheel = (id: string): Box | null => boxesOf(parts.get(id))[0] ?? null;
  const line = new Map<string, Spot>();
  for (const [id, element] of parts) {
    const spot = id.startsWith('line-') ? spotOf(element) : null;
    if (spot !== null) line.set(id.slice('line-'.length), spot);
  }
  const root = all.find((element) => element.name === 'svg');
  const isLeftOut = ({ attributes }: SvgElement): boolean =>
    /^(rgb-\d+|bumper)$/.test(attributes['id'] ?? '') || attributes['class'] === 'tread';
  return {
    svg: without(svg, all.filter(isLeftOut)),
    viewBox: viewBoxOf(root),
    wheels: { left: wheel('wheel-left'), right: wheel('wheel-right') },
    rgb: colourLights(parts),
    leds: { left: spotOf(parts.get('led-left')), right: spotOf(parts.get('led-right')) },
    lamps: { left: spotOf(parts.get('lamp-left')), right: spotOf(parts.get('lamp-right')) },
    line,
    display: boxesOf(parts.get('display')).slice(0, 25),
    bumper: bumperOf(svg, root, parts),
  };
}

function bumperOf(
  svg: string,
  root: SvgElement | undefined,
  parts: ReadonlyMap<string, SvgElement>,
): RobotDrawing['bumper'] {
  const bumper = parts.get('bumper');
  const [left, right] = [parts.get('bumper-left'), parts.get('bumper-right')];
  if (root === undefined || bumper === undefined || left === undefined || right === undefined) return null;
  const defs = root.children.find(({ name }) => name === 'defs');
  const alone = (other: SvgElement): string =>
    without(
      svg.slice(0, bumper.end) + '</svg>',
      root.children.filter((child) => child.start < bumper.start && child !== defs).concat(other),
    );
  return { left: alone(right), right: alone(left) };
}

/** The same drawing with its size in px on the root, as Firefox needs it to draw an SVG image on a canvas. */
export function withPixelSize(svg: string, widthPx: number, heightPx: number): string {
  return svg.replace(/<svg\b[^>]*>/, (root) => {
    const bare = root.replace(/\s(?:width|height)\s*=\s*"[^"]*"/g, '');
    const named = bare.includes('xmlns=') ? bare : bare.replace('<svg', '<svg xmlns="http://www.w3.org/2000/svg"');
    return named.replace('<svg', `<svg width="${String(widthPx)}" height="${String(heightPx)}"`);
  });
}

function colourLights(parts: ReadonlyMap<string, SvgElement>): ColourLight[] {
  const lights: ColourLight[] = [];
  for (let i = 0; ; i += 1) {
    const part = parts.get(`rgb-${String(i)}`);
    const spot = spotOf(part);
    if (spot === null) return lights;
    lights.push({ ...spot, isOnTop: part?.attributes['class'] === 'top' });
  }
}

function without(text: string, elements: readonly SvgElement[]): string {
  let kept = '';
  let from = 0;
  for (const { start, end } of elements) {
    if (start < from) continue;
    kept += text.slice(from, start);
    from = end;
  }
  return kept + text.slice(from);
}

function boxesOf(part: SvgElement | undefined): Box[] {
  if (part === undefined) return [];
  return [...elementsOf(part)]
    .filter((element) => element.name === 'rect')
    .map(({ attributes: a }) => ({
      x: number(a['x']),
      y: number(a['y']),
      width: number(a['width']),
      height: number(a['height']),
    }))
    .filter((box) => box.width > 0 && box.height > 0);
}

function spotOf(part: SvgElement | undefined): Spot | null {
  if (part === undefined) return null;
  const circles = [...elementsOf(part)].filter((element) => element.name === 'circle');
  const circle =
    circles.find((c) => c.attributes['class'] === 'lit') ?? circles.find((c) => c.attributes['class'] !== 'glow');
  if (circle === undefined) return null;
  const { cx, cy, r } = circle.attributes;
  return number(r) > 0 ? { x: number(cx), y: number(cy), radius: number(r) } : null;
}

function number(text: string | undefined): number {
  const value = Number(text ?? 0);
  return Number.isFinite(value) ? value : 0;
}

function viewBoxOf(root: SvgElement | undefined): Box {
  const [x, y, width, height] = (root?.attributes['viewBox'] ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const readable = Number.isFinite(x) && Number.isFinite(y) && number(String(width)) > 0 && number(String(height)) > 0;
  if (!readable) return { x: -80, y: -80, width: 160, height: 160 };
  return { x: x ?? 0, y: y ?? 0, width: width ?? 0, height: height ?? 0 };
}
