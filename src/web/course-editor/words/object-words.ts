import type { Texts } from '#core/texts';
import type { Kind } from '#editor/describe-edit';
import type { Point, Scene, SceneObject } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { numberText } from '../../page/i18n/number-text';
import { say } from '../../page/i18n/say';
import { editorWords as words } from './editor-words';

const texts = words.where;

/** mm as cm with at most one decimal. */
export const cm = (mm: number): number => Math.round(mm) / 10;

/** A place in cm: `10 | 20`. */
export function placeText([x, y]: Point): string {
  const language = shownLanguage();
  return `${numberText(cm(x), language)} | ${numberText(cm(y), language)}`;
}

/** One of a kind by its name, several with their count: `Wand`, `3 Wände`. */
export const countText = (kind: Kind, count: number): string =>
  count === 1 ? say(words.kinds[kind].one) : `${String(count)} ${say(words.kinds[kind].many)}`;

/** What each object is called: `Wand 3`; a checkpoint has its own number, a text its words. */
export function namesOf(scene: Scene): ReadonlyMap<string, string> {
  const counts = new Map<string, number>();
  return new Map(
    scene.objects.map((object) => {
      const count = (counts.get(object.type) ?? 0) + 1;
      counts.set(object.type, count);
      return [object.id, nameOf(object, count)];
    }),
  );
}

function nameOf(object: SceneObject, count: number): string {
  const kind = say(words.kinds[object.type].one);
  if (object.type === 'checkpoint') return `${kind} ${String(object.number)}`;
  if (object.type === 'label') return say(texts.label, { kind, text: object.text });
  return `${kind} ${String(count)}`;
}

/** Where an object is, in words. */
export function whereText(object: SceneObject): string {
  switch (object.type) {
    case 'wall':
      return say(texts.fromTo, { from: placeText(object.from), to: placeText(object.to) });
    case 'stroke': {
      const [first = [0, 0], second] = object.points;
      if (object.points.length === 2 && second !== undefined)
        return say(texts.fromTo, { from: placeText(first), to: placeText(second) });
      return say(texts.points, { at: placeText(first), count: object.points.length });
    }
    case 'mover':
      return say(texts.goes, { from: placeText(object.at), to: placeText(object.to) });
    case 'label':
      return say(texts.at, { at: placeText(object.at) });
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return say(texts.sizeAt, { x: cm(object.size[0]), y: cm(object.size[1]), at: placeText(object.at) });
    default:
      return object satisfies never;
  }
}
