import { sceneDefaults, sceneLimits, type Tag } from '../../scene';
import type { KindReader } from './kind-reader';
import { readAngle, readId, readPlace } from './unread';

export const tag: KindReader<Tag> = {
  properties: ['at', 'number', 'side', 'angle', 'flat'],
  read(given) {
    const { reader, at } = given;
    const isFlat = reader.flag(...at('flat'), false);
    return {
      type: 'tag',
      id: readId(given),
      at: readPlace(given, 'at'),
      number: reader.whole(...at('number'), sceneLimits.tag),
      side: reader.whole(...at('side'), sceneLimits.tagMm, sceneDefaults.tagSide),
      angle: readAngle(given),
      ...(isFlat ? { flat: true } : {}),
    };
  },
};
