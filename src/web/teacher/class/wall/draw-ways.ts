import type { WorldResult } from '#check/result';

import { labelPlaces } from './label-places';
import { drivenUntil } from './timed-way';
import type { Size } from './wall-cards';

/** A way in the picture of all. */
export interface LabelledWay {
  readonly label: string;
  readonly way: Pick<WorldResult, 'trail' | 'trailMs'>;
  /** Simulated ms until it had passed; `null`: it has not. */
  readonly passedMs: number | null;
}

/** Dark enough for the floor, which is light in every theme. None is red: a way is no verdict. */
const COLORS = ['#1e66d0', '#a3278f', '#0b7a75', '#8a5200', '#5b3fc4', '#2f6f1d', '#b0480a', '#46515e'] as const;

/** Width of a line, in mm: two paths side by side on a course can be told apart. */
const WIDTH_MM = 7;
/** Radius of the dot that drives, in mm. */
const ROBOT_MM = 22;

/** The content of the picture. */
export interface WaysPicture {
  readonly ways: readonly LabelledWay[];
  /** Simulated ms until which they are driven. */
  readonly untilMs: number;
  /** Size of the course, in mm. */
  readonly course: Size;
  /** Pixels of the canvas for a mm, and for a px of the page. */
  readonly scale: number;
  readonly ratio: number;
}

/** Draws ways over one another, each with its robot and name where it is by then. */
export function drawWays(
  context: CanvasRenderingContext2D,
  { ways, untilMs, course, scale, ratio }: WaysPicture,
): void {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, course.width * scale, course.height * scale);
  context.lineJoin = 'round';
  const driven = ways.map(({ way, label, passedMs }, place) => ({
    ...{ pieces: drivenUntil(way, untilMs), color: COLORS[place % COLORS.length] ?? COLORS[0] },
    ...(passedMs !== null && passedMs <= untilMs
      ? { label: `${label} ✓`, hasPassed: true }
      : { label, hasPassed: false }),
  }));
  context.globalAlpha = 0.75;
  context.lineWidth = WIDTH_MM * scale;
  for (const { pieces, color } of driven) {
    context.strokeStyle = color;
    context.beginPath();
    for (const piece of pieces)
      for (const [place, [x, y]] of piece.entries()) {
        const at = [x * scale, (course.height - y) * scale] as const;
        if (place === 0) context.moveTo(...at);
        else context.lineTo(...at);
      }
    context.stroke();
  }
  context.globalAlpha = 1;
  const robots = driven.flatMap(({ pieces, color, label, hasPassed }) => {
    const [x, y] = pieces.at(-1)?.at(-1) ?? [];
    if (x === undefined || y === undefined) return [];
    return [{ x: x * scale, y: (course.height - y) * scale, color, label, hasPassed }];
  });
  drawRobots(context, robots, { radius: ROBOT_MM * scale, ratio });
}

interface Robot {
  readonly x: number;
  readonly y: number;
  readonly color: string;
  readonly label: string;
  readonly hasPassed: boolean;
}

/** Dots and their names, both with a light rim. Where there is no room for all names, those who have passed come first. */
function drawRobots(
  context: CanvasRenderingContext2D,
  robots: readonly Robot[],
  { radius, ratio }: { readonly radius: number; readonly ratio: number },
): void {
  context.font = `600 ${String(14 * ratio)}px Roboto, 'Segoe UI', sans-serif`;
  context.strokeStyle = '#fff';
  context.lineWidth = 2 * ratio;
  for (const { x, y, color } of robots) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
    context.stroke();
  }
  const named = robots.toSorted((one, other) => Number(other.hasPassed) - Number(one.hasPassed));
  const places = labelPlaces(
    named.map(({ x, y, label }) => {
      const size = { width: context.measureText(label).width, height: 18 * ratio };
      return { x, y, radius: radius + 4 * ratio, label: size };
    }),
    context.canvas,
  );
  context.lineWidth = 4 * ratio;
  for (const [index, { color, label }] of named.entries()) {
    const place = places[index];
    if (!place) continue;
    context.fillStyle = color;
    context.strokeText(label, place.left, place.top + 14 * ratio);
    context.fillText(label, place.left, place.top + 14 * ratio);
  }
}
