import { pair, property } from '../json-text';
import { boxOutline, type Outline } from '../outline';
import { optionsProperty } from '../robot-values';
import { sceneDefaults, type Start } from '../scene';
import { filling, type SceneKind } from './kind';

/** The start of a further device's robot. */
export const start: SceneKind<Start> = {
  name: 'start',
  write: ({ at, heading, robot, options, name, color }) => [
    `"at": ${pair(at)}`,
    ...property('heading', heading, sceneDefaults.heading),
    ...property('robot', robot, null),
    ...optionsProperty(options),
    ...property('name', name, ''),
    ...property('color', color, null),
  ],
  solid: () => [],
  ...filling(startOutline),
};

/** Side of the box on the floor in which a robot starts, in mm. Chosen: a robot of 13 cm stands in it. */
export const START_SIDE_MM = 140;

/** The outline of a start in any orientation: good enough to grab it, and to find room for it. World mm. */
export function startOutline({ at }: Start): Outline {
  return boxOutline({ at, size: [START_SIDE_MM, START_SIDE_MM], angle: 0 });
}
