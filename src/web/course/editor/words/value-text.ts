import { moverWays, type MoverWay } from '#scene/kinds/mover-way';
import type { PaintColor } from '#scene/paint';
import type { RobotColor, SceneObject } from '#scene/scene';

import type { ShapeName } from '#scene/shape/shape';

import { t } from '../../../kit/i18n';
import words from './editing';
import moverWords from './movers';

/** A colour, a kind a shape or what a mover does, in words. */
export function valueText(
  value: PaintColor | RobotColor | 'auto' | SceneObject['type'] | MoverWay | ShapeName,
): string {
  if (isWay(value)) return t(moverWords.ways[value]);
  return value in words.options ? t(words.options[value as keyof typeof words.options]) : value;
}

const isWay = (value: string): value is MoverWay => moverWays.some((way) => way === value);
