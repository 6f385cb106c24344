import type { Texts } from '#core/texts';
import type { Kind } from '#editor/describe-edit';
import type { Point, Scene, SceneObject } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { numberText } from '../../page/i18n/number-text';
import { say } from '../../page/i18n/say';

/** What kinds of objects are called: one, and several. */
export const kindTexts: Readonly<Record<Kind, { readonly one: Texts; readonly many: Texts }>> = {
  wall: {
    one: { de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' },
    many: { de: 'Wände', fr: 'Murs', it: 'Muri', en: 'Walls' },
  },
  block: {
    one: { de: 'Block', fr: 'Bloc', it: 'Blocco', en: 'Block' },
    many: { de: 'Blöcke', fr: 'Blocs', it: 'Blocchi', en: 'Blocks' },
  },
  'fixed-block': {
    one: { de: 'Fester Block', fr: 'Bloc fixe', it: 'Blocco fisso', en: 'Fixed block' },
    many: { de: 'Feste Blöcke', fr: 'Blocs fixes', it: 'Blocchi fissi', en: 'Fixed blocks' },
  },
  spikes: {
    one: { de: 'Stacheln', fr: 'Pics', it: 'Punte', en: 'Spikes' },
    many: { de: 'Stacheln', fr: 'Pics', it: 'Punte', en: 'Spikes' },
  },
  mover: {
    one: { de: 'Fahrender Block', fr: 'Bloc mobile', it: 'Blocco mobile', en: 'Moving block' },
    many: { de: 'Fahrende Blöcke', fr: 'Blocs mobiles', it: 'Blocchi mobili', en: 'Moving blocks' },
  },
  stroke: {
    one: { de: 'Linie', fr: 'Ligne', it: 'Linea', en: 'Line' },
    many: { de: 'Linien', fr: 'Lignes', it: 'Linee', en: 'Lines' },
  },
  target: {
    one: { de: 'Ziel', fr: 'Arrivée', it: 'Arrivo', en: 'Target' },
    many: { de: 'Ziele', fr: 'Arrivées', it: 'Arrivi', en: 'Targets' },
  },
  checkpoint: {
    one: { de: 'Kontrollpunkt', fr: 'Point de contrôle', it: 'Punto di controllo', en: 'Checkpoint' },
    many: { de: 'Kontrollpunkte', fr: 'Points de contrôle', it: 'Punti di controllo', en: 'Checkpoints' },
  },
  forbidden: {
    one: { de: 'Verbotenes Feld', fr: 'Zone interdite', it: 'Zona vietata', en: 'Forbidden field' },
    many: { de: 'Verbotene Felder', fr: 'Zones interdites', it: 'Zone vietate', en: 'Forbidden fields' },
  },
  label: {
    one: { de: 'Text', fr: 'Texte', it: 'Testo', en: 'Text' },
    many: { de: 'Texte', fr: 'Textes', it: 'Testi', en: 'Texts' },
  },
  several: {
    one: { de: 'Ding', fr: 'Objet', it: 'Oggetto', en: 'Thing' },
    many: { de: 'Dinge', fr: 'Objets', it: 'Oggetti', en: 'Things' },
  },
};

/** mm as cm with at most one decimal. */
export const cm = (mm: number): number => Math.round(mm) / 10;

/** A place in cm: `10 | 20`. */
export function placeText([x, y]: Point): string {
  const language = shownLanguage();
  return `${numberText(cm(x), language)} | ${numberText(cm(y), language)}`;
}

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
  if (object.type === 'label') return say(texts.label, { kind, text: object.text });
  return `${kind} ${String(count)}`;
}

const texts = {
  label: {
    de: '{kind} «{text}»',
    fr: '{kind} « {text} »',
    it: '{kind} «{text}»',
    en: '{kind} “{text}”',
  },
  fromTo: {
    de: 'von {from} bis {to} cm',
    fr: 'de {from} à {to} cm',
    it: 'da {from} a {to} cm',
    en: 'from {from} to {to} cm',
  },
  at: { de: 'bei {at} cm', fr: 'à {at} cm', it: 'a {at} cm', en: 'at {at} cm' },
  sizeAt: {
    de: '{x} × {y} cm bei {at} cm',
    fr: '{x} × {y} cm à {at} cm',
    it: '{x} × {y} cm a {at} cm',
    en: '{x} × {y} cm at {at} cm',
  },
  goes: { de: '{from} ↔ {to} cm', fr: '{from} ↔ {to} cm', it: '{from} ↔ {to} cm', en: '{from} ↔ {to} cm' },
  points: {
    de: 'ab {at} cm, {count} Punkte',
    fr: 'dès {at} cm, {count} points',
    it: 'da {at} cm, {count} punti',
    en: 'from {at} cm, {count} points',
  },
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
