import type { Texts } from '#core/texts';
import type { Kind } from '#editor/describe-edit';
import type { Point, Scene, SceneObject } from '#scene/scene';

import { say } from '../i18n/say';

/** What kinds of objects are called: one, and several. */
export const kindTexts: Readonly<Record<Kind, { readonly one: Texts; readonly many: Texts }>> = {
  wall: { one: { de: 'Wand', en: 'Wall' }, many: { de: 'Wände', en: 'Walls' } },
  block: { one: { de: 'Block', en: 'Block' }, many: { de: 'Blöcke', en: 'Blocks' } },
  'fixed-block': { one: { de: 'Fester Block', en: 'Fixed block' }, many: { de: 'Feste Blöcke', en: 'Fixed blocks' } },
  spikes: { one: { de: 'Stacheln', en: 'Spikes' }, many: { de: 'Stacheln', en: 'Spikes' } },
  mover: { one: { de: 'Fahrender Block', en: 'Moving block' }, many: { de: 'Fahrende Blöcke', en: 'Moving blocks' } },
  stroke: { one: { de: 'Linie', en: 'Line' }, many: { de: 'Linien', en: 'Lines' } },
  target: { one: { de: 'Ziel', en: 'Target' }, many: { de: 'Ziele', en: 'Targets' } },
  checkpoint: { one: { de: 'Kontrollpunkt', en: 'Checkpoint' }, many: { de: 'Kontrollpunkte', en: 'Checkpoints' } },
  forbidden: {
    one: { de: 'Verbotenes Feld', en: 'Forbidden field' },
    many: { de: 'Verbotene Felder', en: 'Forbidden fields' },
  },
  label: { one: { de: 'Text', en: 'Text' }, many: { de: 'Texte', en: 'Texts' } },
  several: { one: { de: 'Ding', en: 'Thing' }, many: { de: 'Dinge', en: 'Things' } },
};

/** mm as cm with at most one decimal. */
export const cm = (mm: number): number => Math.round(mm) / 10;

/** A place in cm: `10 | 20`. */
export const placeText = ([x, y]: Point): string => `${String(cm(x))} | ${String(cm(y))}`;

/** One of a kind by its name, several with their count: `Wand`, `3 Wände`. */
export const countText = (kind: Kind, count: number): string =>
  count === 1 ? say(kindTexts[kind].one) : `${String(count)} ${say(kindTexts[kind].many)}`;

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
  const kind = say(kindTexts[object.type].one);
  if (object.type === 'checkpoint') return `${kind} ${String(object.number)}`;
  if (object.type === 'label') return `${kind} «${object.text}»`;
  return `${kind} ${String(count)}`;
}

const texts = {
  fromTo: { de: 'von {from} bis {to} cm', en: 'from {from} to {to} cm' },
  at: { de: 'bei {at} cm', en: 'at {at} cm' },
  sizeAt: { de: '{x} × {y} cm bei {at} cm', en: '{x} × {y} cm at {at} cm' },
  goes: { de: '{from} ↔ {to} cm', en: '{from} ↔ {to} cm' },
  points: { de: 'ab {at} cm, {count} Punkte', en: 'from {at} cm, {count} points' },
};

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
