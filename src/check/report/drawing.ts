import { lightColors } from '#picture/colors';
import { courseShapes } from '#picture/course';
import { svgOf } from '#picture/svg';
import type { Point, Scene } from '#scene/scene';
import type { WorldResult } from '../result';
import type { ClassTask } from '../task/task';
import { courseOfWorld } from '../task/world-course';
import { escaped } from './escaped';

const WAY = '#1e66d0';

/** Colours of ways that passed, did something wrong, or missed something: each holds on the light floor. */
export const wayTones = { passed: '#1b7a3a', wrong: '#c3262b', missing: '#7a5200' } as const;
export type WayTone = keyof typeof wayTones;

/** Ways over one another, one of them before the others, with a place that is meant. */
export interface WaysToDraw {
  /** Id of the world. */
  readonly world: string;
  readonly trails: readonly WorldResult['trail'][];
  readonly tone: WayTone;
  /** The way of an example; `null`: none is before the others. */
  readonly example: WorldResult['trail'] | null;
  /** A place with the words to it; `null`: none. */
  readonly mark: { readonly at: Point; readonly radius: number; readonly text: string } | null;
}

/** The courses of the task's worlds, each drawn once. */
export class Drawings {
  private readonly courses: ReadonlyMap<string, { readonly inside: string; readonly size: readonly [number, number] }>;

  constructor(task: ClassTask) {
    this.courses = new Map(
      task.worlds.map((world) => {
        const course = courseOfWorld(task.project.scene, world);
        const scene = 'problem' in course ? task.project.scene : course.scene;
        return [world.id, { inside: courseDrawing(scene), size: scene.size }];
      }),
    );
  }

  /** Definitions that all drawings refer to. */
  shared(): string {
    return [...this.courses.values()].map(({ inside }, place) => `<g id="course-${place}">${inside}</g>`).join('');
  }

  /** The trail in a world over its course. */
  way(world: Pick<WorldResult, 'id' | 'trail'>, label: string): string {
    return this.over(world.id, label, ([, height]) => wayDrawing(world, height));
  }

  /** Ways in a world over one another. */
  ways({ world, trails, tone, example, mark }: WaysToDraw, label: string): string {
    return this.over(world, label, (size) => {
      const [width, height] = size;
      const all = trails.map((trail) => linesOf(trail, height, { color: wayTones[tone], wide: width / 110, opacity: 0.6 })); // prettier-ignore
      const own = example === null ? '' : linesOf(example, height, { color: '#fff', wide: width / 75, opacity: 1 }) + linesOf(example, height, { color: WAY, wide: width / 150, opacity: 1 }) + endDot(example, height, width / 75); // prettier-ignore
      return all.join('') + own + (mark === null ? '' : markDrawing(mark, size));
    });
  }

  private over(world: string, label: string, drawn: (size: Scene['size']) => string): string {
    const course = this.courses.get(world);
    if (course === undefined) return '';
    const [width, height] = course.size;
    const place = [...this.courses.keys()].indexOf(world);
    const name = label === '' ? 'aria-hidden="true"' : `role="img" aria-label="${escaped(label)}"`;
    return `<svg viewBox="0 0 ${width} ${height}" ${name}><use href="#course-${place}"/>${drawn(course.size)}</svg>`;
  }
}

/** Drawings are about so many pixels wide: what is smaller than they show is left out. Chosen: a column of the report. */
const WIDE_PX = 400;

/** A course as the inside of an SVG whose unit is a mm and whose y axis points down, for many drawings of it. */
function courseDrawing({ size: [width, height], objects }: Scene): string {
  const look = { colors: lightColors, px: Math.max(width, height) / WIDE_PX, seconds: String };
  const floor = `<rect fill="${lightColors.floor}" width="${width}" height="${height}"/>`;
  return floor + svgOf(courseShapes(objects, look), ([x, y]) => [x, height - y]);
}

/** The trail of a robot over the course, with a dot at its end. */
const wayDrawing = ({ trail }: Pick<WorldResult, 'trail'>, height: number): string =>
  linesOf(trail, height, { color: WAY, wide: 10, opacity: 1 }) + endDot(trail, height, 18);

const linesOf = (
  trail: WorldResult['trail'],
  height: number,
  { color, wide, opacity }: { readonly color: string; readonly wide: number; readonly opacity: number },
): string =>
  trail
    .map(
      (piece) =>
        `<polyline fill="none" stroke="${color}" stroke-width="${rounded(wide)}"${opacity === 1 ? '' : ` stroke-opacity="${opacity}"`} stroke-linejoin="round" points="${pointsOf(piece, height)}"/>`,
    )
    .join('');

function endDot(trail: WorldResult['trail'], height: number, radius: number): string {
  const [x, y] = trail.at(-1)?.at(-1) ?? [];
  return x === undefined || y === undefined
    ? ''
    : `<circle fill="${WAY}" cx="${x}" cy="${height - y}" r="${rounded(radius)}"/>`;
}

/** A dashed ring round a place, and the words to it in a field above or below. */
function markDrawing(
  { at: [x, y], radius, text }: NonNullable<WaysToDraw['mark']>,
  [width, height]: Scene['size'],
): string {
  // prettier-ignore
  const unit = width / 40;
  const ring = Math.max(radius + unit, 2 * unit);
  const [cx, cy] = [x, height - y];
  const half = Math.min(width / 2, (text.length * unit * 0.58 + 1.6 * unit) / 2);
  const middle = Math.min(width - half, Math.max(half, cx));
  const top = cy - ring - 2.4 * unit > 0 ? cy - ring - 2.3 * unit : Math.min(height - 2 * unit, cy + ring + 0.4 * unit);
  const field =
    text === ''
      ? ''
      : `<rect x="${rounded(middle - half)}" y="${rounded(top)}" width="${rounded(2 * half)}" height="${rounded(1.9 * unit)}" rx="${rounded(0.95 * unit)}" fill="${wayTones.missing}"/><text x="${rounded(middle)}" y="${rounded(top + 1.35 * unit)}" font-family="Roboto, 'Segoe UI', sans-serif" font-size="${rounded(1.1 * unit)}" font-weight="600" text-anchor="middle" fill="#fff">${escaped(text)}</text>`;
  return `<circle cx="${cx}" cy="${cy}" r="${rounded(ring)}" fill="none" stroke="${wayTones.missing}" stroke-width="${rounded(unit / 6)}" stroke-dasharray="${rounded(unit / 2)} ${rounded(unit / 3)}"/>${field}`;
}

const pointsOf = (points: readonly Point[], height: number): string =>
  points.map(([x, y]) => `${rounded(x)},${rounded(height - y)}`).join(' ');

const rounded = (mm: number): number => Math.round(mm * 10) / 10;
