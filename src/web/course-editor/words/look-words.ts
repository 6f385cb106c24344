import type { SceneObject } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { numberText } from '../../page/i18n/number-text';
import { say } from '../../page/i18n/say';
import { cm } from './object-words';
import editingWords from './editing';

const words = editingWords.options;

/** What an object looks like and wants, in words, beside its place; empty where its name says all. */
export function lookText(object: SceneObject): string {
  const angle = 'angle' in object ? object.angle : 0;
  const turned = angle === 0 ? [] : [`${say(editingWords.fields.turn)} ${numberText(angle, shownLanguage())}°`];
  return [...looksOf(object), ...turned].join(', ');
}

function looksOf(object: SceneObject): readonly string[] {
  switch (object.type) {
    case 'stroke':
      return [say(words[object.color]), say(words.widthMm, { mm: object.width })];
    case 'wall':
      return [say(words.thicknessMm, { mm: object.thickness })];
    case 'target':
      return object.blocks === 0 ? [] : [say(words.blocksSome, { count: object.blocks })];
    case 'mover': {
      const speed = say(words.speedCmS, { cm: numberText(cm(object.speed), shownLanguage()) });
      return object.spiked ? [speed, say(words.spiked)] : [speed];
    }
    default:
      return [];
  }
}
