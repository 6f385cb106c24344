import { pair, property } from '../json-text';
import { boxOutline, type Outline } from '../outline';
import { sceneDefaults, type Lamp } from '../scene';
import { switchingText } from './switching';
import { filling, type SceneKind } from './kind';

/** Lamps. They hang over the arena: nothing bumps into them. */
export const lamp: SceneKind<Lamp> = {
  name: 'lamp',
  write: ({ at, height, brightness, color, on }) => [
    `"at": ${pair(at)}`,
    ...property('height', height, sceneDefaults.lampHeight),
    ...property('brightness', brightness, sceneDefaults.brightness),
    ...property('color', color ?? null, null),
    ...(on === undefined ? [] : [`"on": ${switchingText(on)}`]),
  ],
  solid: () => [],
  ...filling(lampOutline),
};

/** Width of the disc that shows a lamp, in mm. Chosen: a finger hits it. */
export const LAMP_MM = 44;

/** The square around a lamp's disc, in world mm. */
export function lampOutline({ at }: Lamp): Outline {
  return boxOutline({ at, size: [LAMP_MM, LAMP_MM], angle: 0 });
}
