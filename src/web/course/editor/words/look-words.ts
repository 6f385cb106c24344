import { ownHeightOf } from '#scene/kinds/heights';
import type { SceneObject } from '#scene/scene';

import { shownLanguage, t } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { cm } from './object-words';
import editingWords from './editing';

const words = editingWords.options;

/** An object's look and purpose in words, beside its place; empty if its name says all. */
export function lookText(object: SceneObject): string {
  const angle = 'angle' in object ? object.angle : 0;
  const turned = angle === 0 ? [] : [`${t(editingWords.fields.turn)} ${numberText(angle, shownLanguage())}°`];
  const height = ownHeightOf(object);
  const high = height === null ? [] : [t(words.heightMm, { mm: height })];
  return [...looksOf(object), ...high, ...turned].join(', ');
}

function looksOf(object: SceneObject): readonly string[] {
  switch (object.type) {
    case 'stroke':
      return [t(words[object.color]), t(words.widthMm, { mm: object.width })];
    case 'wall':
      return [t(words.thicknessMm, { mm: object.thickness })];
    case 'target':
      return object.blocks === 0 ? [] : [t(words.blocksSome, { count: object.blocks })];
    case 'paper':
      return [t(words[object.color])];
    case 'mover': {
      const speed = t(words.speedCmS, { cm: numberText(cm(object.speed), shownLanguage()) });
      return object.spiked ? [speed, t(words.spiked)] : [speed];
    }
    default:
      return [];
  }
}
