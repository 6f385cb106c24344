import type { RobotColor, SceneObject, StrokeColor } from '#scene/scene';

import { say } from '../../page/i18n/say';
import { editingWords as words } from './editing-words';

/** A colour or a kind in words. */
export function valueText(value: StrokeColor | RobotColor | 'auto' | SceneObject['type']): string {
  return value in words.options ? say(words.options[value as keyof typeof words.options]) : value;
}
