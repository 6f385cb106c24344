import { sceneDefaults, sceneLimits, type Label } from '../../scene';
import type { KindReader } from './kind-reader';
import { readAngle, readId, readPlace } from './unread';

const LINE_BREAK = /[\n\r\u2028\u2029]/;

export const label: KindReader<Label> = {
  properties: ['at', 'text', 'height', 'angle'],
  read(given) {
    const { reader, at } = given;
    const [value, path] = at('text');
    const text = reader.text(value, path, sceneLimits.labelCharacters);
    if (value === '') reader.report('missing', path, text, 'must not be empty.');
    if (LINE_BREAK.test(text)) reader.report('not-one-line', path, text, 'must be a single line.');
    return {
      type: 'label',
      id: readId(given),
      at: readPlace(given, 'at'),
      text,
      height: reader.whole(...at('height'), sceneLimits.labelMm, sceneDefaults.labelHeight),
      angle: readAngle(given),
    };
  },
};
