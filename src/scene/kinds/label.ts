import { pair, property } from '../json-text';
import { boxOutline, type Outline } from '../outline';
import { sceneDefaults, sceneLimits, type Label } from '../scene';
import { filling, type SceneKind } from './kind';
import { readAngle, readId, readPlace } from './unread';

const LINE_BREAK = /[\n\r\u2028\u2029]/;

/** Words on the floor. */
export const label: SceneKind<Label> = {
  name: 'label',
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
  write: ({ at, text, height, angle }, rotation) => [
    `"at": ${pair(at)}`,
    `"text": ${JSON.stringify(text)}`,
    ...property('height', height, sceneDefaults.labelHeight),
    ...rotation(angle),
  ],
  solid: () => [],
  ...filling(labelOutline),
};

// chosen: a bold sans serif letter is 0.8 of a capital's height wide on average; capitals are 0.72 of the line
const LETTER_WIDTH = 0.8;
const LINE_HEIGHT = 1.4;

/** The box a label is taken to fill; how wide its letters really are differs between screens. */
export function labelOutline({ at, text, height, angle }: Label): Outline {
  return boxOutline({ at, size: [text.length * height * LETTER_WIDTH, height * LINE_HEIGHT], angle });
}
