import { solidParts } from '#scene/kinds/index';
import { isZone } from '#scene/kinds/zone';
import type { Outline } from '#scene/outline';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import type { WorldResult } from '../result';

/** A course as the inside of an SVG whose unit is a mm and whose y axis points down, for many drawings of it. */
export function courseDrawing({ size: [width, height], objects }: Scene): string {
  const floor = `<rect class="floor" width="${width}" height="${height}"/>`;
  const isBelow = (object: SceneObject): boolean => isZone(object) || object.type === 'stroke';
  const painted = [...objects.filter(isBelow), ...objects.filter((object) => !isBelow(object))];
  return floor + painted.map((object) => drawn(object, height)).join('');
}

function drawn(object: SceneObject, height: number): string {
  if (object.type === 'stroke') {
    const { width, color, points } = object;
    return `<polyline class="line" stroke="${color}" stroke-width="${width}" points="${pointsOf(points, height)}"/>`;
  }
  const name = isZone(object) ? `zone ${object.type}` : object.type;
  const parts = isZone(object) ? [shapeOutline(object)] : solidParts(object);
  return parts.map((part) => `<polygon class="${name}" points="${cornersOf(part, height)}"/>`).join('');
}

/** The way of a robot over the course, with a dot where it ended. */
export function wayDrawing({ trail }: Pick<WorldResult, 'trail'>, height: number): string {
  const lines = trail.map((piece) => `<polyline class="way" points="${pointsOf(piece, height)}"/>`);
  const [x, y] = trail.at(-1)?.at(-1) ?? [];
  const end = x === undefined || y === undefined ? '' : `<circle class="end" cx="${x}" cy="${height - y}" r="18"/>`;
  return lines.join('') + end;
}

const pointsOf = (points: readonly Point[], height: number): string =>
  points.map(([x, y]) => `${rounded(x)},${rounded(height - y)}`).join(' ');

const cornersOf = (outline: Outline, height: number): string =>
  pointsOf(
    outline.map(({ x, y }): Point => [x, y]),
    height,
  );

const rounded = (mm: number): number => Math.round(mm * 10) / 10;
