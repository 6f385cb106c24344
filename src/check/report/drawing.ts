import { lightColors } from '#picture/colors';
import { courseShapes } from '#picture/course';
import { svgOf } from '#picture/svg';
import type { Point, Scene } from '#scene/scene';
import type { WorldResult } from '../result';
import type { ClassTask } from '../task/task';
import { courseOfWorld } from '../task/world-course';
import { escaped } from './escaped';

const WAY = '#1e66d0';

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
    const course = this.courses.get(world.id);
    if (course === undefined) return '';
    const [width, height] = course.size;
    const place = [...this.courses.keys()].indexOf(world.id);
    const name = label === '' ? 'aria-hidden="true"' : `role="img" aria-label="${escaped(label)}"`;
    return `<svg viewBox="0 0 ${width} ${height}" ${name}><use href="#course-${place}"/>${wayDrawing(world, height)}</svg>`;
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
function wayDrawing({ trail }: Pick<WorldResult, 'trail'>, height: number): string {
  const lines = trail.map(
    (piece) =>
      `<polyline fill="none" stroke="${WAY}" stroke-width="10" stroke-linejoin="round" points="${pointsOf(piece, height)}"/>`,
  );
  const [x, y] = trail.at(-1)?.at(-1) ?? [];
  const end = x === undefined || y === undefined ? '' : `<circle fill="${WAY}" cx="${x}" cy="${height - y}" r="18"/>`;
  return lines.join('') + end;
}

const pointsOf = (points: readonly Point[], height: number): string =>
  points.map(([x, y]) => `${rounded(x)},${rounded(height - y)}`).join(' ');

const rounded = (mm: number): number => Math.round(mm * 10) / 10;
