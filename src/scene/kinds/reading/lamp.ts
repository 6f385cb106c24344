import { lampColors, sceneDefaults, sceneLimits, type Lamp } from '../../scene';
import type { KindReader } from './kind-reader';
import { readSwitching } from './switching';
import { readId, readPlace } from './unread';

export const lamp: KindReader<Lamp> = {
  properties: ['at', 'height', 'brightness', 'color', 'on'],
  read(given) {
    const { reader, at } = given;
    const [color, colorPath] = at('color');
    const [on, onPath] = at('on');
    return {
      type: 'lamp',
      id: readId(given),
      at: readPlace(given, 'at'),
      height: reader.whole(...at('height'), sceneLimits.lampMm, sceneDefaults.lampHeight),
      brightness: reader.number(...at('brightness'), sceneLimits.brightnessCd, sceneDefaults.brightness),
      ...(color === undefined ? {} : { color: reader.word(color, colorPath, lampColors, 'red') }),
      ...(on === undefined ? {} : { on: readSwitching(on, onPath, reader) }),
    };
  },
};
