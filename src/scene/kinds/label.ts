import { pair, property } from '../json-text';
import { boxOutline, type Outline } from '../outline';
import { sceneDefaults, type Label } from '../scene';
import { filling, type SceneKind } from './kind';

/** Words on the floor. */
export const label: SceneKind<Label> = {
  name: 'label',
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
