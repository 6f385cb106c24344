import { radOf } from '#core/angle';
import { START_SIDE_MM } from '#scene/kinds/start';
import { robotColors, type Point, type Start } from '#scene/scene';

import { deviceColor } from '../device-colors';
import type { Look } from '../look';
import { group, rect, type Paint, type Shape } from '../shapes';
import type { PictureKind } from './kind';

/** Starts of further robots: a dashed box with an arrow ahead and the robot's name behind. */
export const start: PictureKind<Start> = {
  mark: (start, look) => startShapes(start, look, (fill) => ({ fill })),
  paper: (start, look) => startShapes(start, look, (stroke) => ({ stroke, width: 3 })),
  frame: ({ at: [x, y], heading }) => ({
    at: { x, y },
    angleRad: radOf(heading),
    size: { x: START_SIDE_MM, y: START_SIDE_MM },
  }),
};

const SIDE = START_SIDE_MM;
const NAME_MM = 0.16 * SIDE;
/** The tip and the wings of the arrow, in the robot's frame. */
const ARROW: readonly Point[] = [
  [0.42 * SIDE, 0],
  [0.24 * SIDE, 0.14 * SIDE],
  [0.24 * SIDE, -0.14 * SIDE],
];

function startShapes(
  { at, heading, name, color }: Start,
  { colors, px, leastTypeMm = 0 }: Look,
  arrow: (color: string) => Paint,
): readonly Shape[] {
  const stroke = color === null ? colors.label : deviceColor(robotColors.indexOf(color));
  const size = Math.max(NAME_MM, leastTypeMm);
  // Larger than it is, the name has no room in the box.
  const behind = size > NAME_MM ? SIDE / 2 + 0.85 * size : 0.38 * SIDE + 0.355 * size;
  const words: Shape = {
    ...{ form: 'words', text: name, at: [0, behind], from: 'middle', size, weight: 600, fill: stroke },
    ...(size > NAME_MM ? {} : { mostMm: 0.9 * SIDE }),
  };
  const inside: readonly Shape[] = [
    rect([SIDE, SIDE], 0, { stroke, width: Math.max(1.5 * px, SIDE / 50), dash: [SIDE / 12, SIDE / 20] }),
    { form: 'lines', lines: [ARROW], isClosed: true, ...arrow(stroke) },
    ...(name === '' || size < 6 * px ? [] : [group([0, 0], [words], -90)]),
  ];
  return [group(at, inside, heading)];
}
