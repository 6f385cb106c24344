import { moverWays, type MoverWay } from '#scene/kinds/mover-way';
import type { PaintColor } from '#scene/paint/paint';
import type { LampColor, RobotColor, SceneObject } from '#scene/scene';
import type { SwitchPin, SwitchWay } from '#scene/kinds/switching';

import type { ShapeName } from '#scene/shape/shape';

import { t } from '../../../kit/i18n';
import words from './editing';
import moverWords from './movers';

/** A value of a choice in words: a colour, a kind, a shape, what a mover does, what switches a lamp. */
export function valueText(
  value:
    | (PaintColor | 'any' | RobotColor | 'auto' | LampColor | 'warm')
    | (SceneObject['type'] | MoverWay | ShapeName)
    | (SwitchWay | 'always' | 'a' | 'b' | SwitchPin),
): string {
  if (isWay(value)) return t(moverWords.ways[value]);
  const switching = SWITCHING[value];
  if (switching !== undefined) return t(words.options[switching]);
  if (value === 'a' || value === 'b') return value.toUpperCase();
  return value in words.options ? t(words.options[value as keyof typeof words.options]) : value;
}

/** The ways of switching among the words. */
const SWITCHING: Readonly<Record<string, 'byHand' | 'byTime' | 'byRadio' | 'byButton' | 'byPin' | undefined>> = {
  ...{ hand: 'byHand', time: 'byTime', radio: 'byRadio', button: 'byButton', pin: 'byPin' },
};

const isWay = (value: string): value is MoverWay => moverWays.some((way) => way === value);
