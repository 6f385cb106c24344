import { solidParts } from '#scene/kinds/index';
import { isZone } from '#scene/kinds/zone';
import type { Outline } from '#scene/outline';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import type { WorldResult } from '../result';
import type { ClassTask } from '../task/task';
import { courseOfWorld } from '../task/world-course';
import { escaped } from './escaped';

/** Styles of the parts of a course: colours that differ in grey, too. */
const LINE = 'fill="none" stroke-linecap="round" stroke-linejoin="round"';
const ZONE = 'fill="#2563b8" fill-opacity="0.11" stroke="#2563b8" stroke-width="6"';
const FORBIDDEN = 'fill="#c3262b" fill-opacity="0.13" stroke="#c3262b" stroke-width="6"';
const SOLID = { wall: '#4b5563', block: '#a9dec5' } as const;
const OTHER_SOLID = '#b3282d';
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

/** A course as the inside of an SVG whose unit is a mm and whose y axis points down, for many drawings of it. */
function courseDrawing({ size: [width, height], objects }: Scene): string {
  const floor = `<rect fill="#fbfaf7" width="${width}" height="${height}"/>`;
  const isBelow = (object: SceneObject): boolean => isZone(object) || object.type === 'stroke';
  const painted = [...objects.filter(isBelow), ...objects.filter((object) => !isBelow(object))];
  return floor + painted.map((object) => drawn(object, height)).join('');
}

function drawn(object: SceneObject, height: number): string {
  if (object.type === 'stroke') {
    const { width, color, points } = object;
    return `<polyline ${LINE} stroke="${color}" stroke-width="${width}" points="${pointsOf(points, height)}"/>`;
  }
  const parts = isZone(object) ? [shapeOutline(object)] : solidParts(object);
  return parts.map((part) => `<polygon ${lookOf(object)} points="${cornersOf(part, height)}"/>`).join('');
}

function lookOf(object: SceneObject): string {
  if (isZone(object)) return object.type === 'forbidden' ? FORBIDDEN : ZONE;
  return `fill="${object.type === 'wall' || object.type === 'block' ? SOLID[object.type] : OTHER_SOLID}"`;
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

const cornersOf = (outline: Outline, height: number): string =>
  pointsOf(
    outline.map(({ x, y }): Point => [x, y]),
    height,
  );

const rounded = (mm: number): number => Math.round(mm * 10) / 10;
