import { sceneDefaults, sceneLimits, type Start } from '../../scene';
import type { KindReader } from './kind-reader';
import { readOptions, readRobotColor, readRobotName, readTypeId } from './robot-values';
import { readId, readPlace } from './unread';

export const start: KindReader<Start> = {
  properties: ['at', 'heading', 'robot', 'options', 'name', 'color'],
  read(given) {
    const { reader, at } = given;
    const [options, optionsPath] = at('options');
    const [name, namePath] = at('name');
    const [color, colorPath] = at('color');
    return {
      type: 'start',
      id: readId(given),
      at: readPlace(given, 'at'),
      heading: reader.number(...at('heading'), sceneLimits.headingDeg, sceneDefaults.heading),
      robot: readTypeId(...at('robot'), reader),
      options: options === undefined ? {} : readOptions(options, optionsPath, reader),
      name: name === undefined ? '' : readRobotName(name, namePath, reader),
      color: color === undefined ? null : readRobotColor(color, colorPath, reader),
    };
  },
};
