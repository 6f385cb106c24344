import type { Texts } from '#core/texts';
import type { RuleCode, RuleProblem } from '#scene/rules';
import type { Scene, SceneObject } from '#scene/scene';

import { shownLanguage } from '../../page/i18n';
import { say } from '../../page/i18n/say';
import { kindTexts, namesOf } from './object-words';

/** What is not right about a course, and what to do. */
const texts: Readonly<Record<RuleCode, Texts>> = {
  'robot-outside': {
    de: 'Der Roboter ragt am Start aus der Arena hinaus.',
    fr: 'Au départ, le robot dépasse de l’arène.',
    it: 'Alla partenza il robot sporge dall’arena.',
    en: 'The robot sticks out of the arena at its start.',
  },
  'robot-inside': {
    de: 'Am Start des Roboters steht etwas im Weg: {what}.',
    fr: 'Au départ, quelque chose gêne le robot : {what}.',
    it: 'Alla partenza qualcosa è in mezzo al robot: {what}.',
    en: 'Something is in the way at the robot’s start: {what}.',
  },
  'start-on-forbidden': {
    de: 'Der Roboter startet auf dem verbotenen Feld.',
    fr: 'Le robot part sur la zone interdite.',
    it: 'Il robot parte sulla zona vietata.',
    en: 'The robot starts on the forbidden field.',
  },
  'done-at-start': {
    de: 'Der Roboter startet schon im Ziel.',
    fr: 'Le robot part déjà à l’arrivée.',
    it: 'Il robot parte già all’arrivo.',
    en: 'The robot starts in the target already.',
  },
  'task-without-end': {
    de: 'Nichts berühren, aber wohin? Füge ein Ziel oder eine Zeit hinzu.',
    fr: 'Ne rien toucher, mais pour aller où ? Ajoute une arrivée ou un temps.',
    it: 'Non toccare niente, ma per andare dove? Aggiungi un arrivo o un tempo.',
    en: 'Touch nothing, but where to? Add a target or a time.',
  },
  'object-outside': {
    de: '{what} liegt ausserhalb der Arena.',
    fr: 'Hors de l’arène : {what}.',
    it: 'Fuori dall’arena: {what}.',
    en: '{what} lies outside the arena.',
  },
  'checkpoint-number-twice': {
    de: '{count} Kontrollpunkte haben die Nummer {number}.',
    fr: '{count} points de contrôle ont le numéro {number}.',
    it: '{count} punti di controllo hanno il numero {number}.',
    en: '{count} checkpoints have the number {number}.',
  },
  'checkpoint-gap': {
    de: 'Kontrollpunkt {missing} fehlt: Nach der Lücke kommt {number}.',
    fr: 'Il manque le point de contrôle {missing} : après le trou vient le {number}.',
    it: 'Manca il punto di controllo {missing}: dopo il buco viene il {number}.',
    en: 'Checkpoint {missing} is missing: after the gap comes {number}.',
  },
  'target-wants-too-many-blocks': {
    de: 'Die Ziele wollen {wanted} bewegliche Blöcke, es gibt {there}.',
    fr: 'Les arrivées demandent {wanted} blocs libres, il y en a {there}.',
    it: 'Gli arrivi richiedono {wanted} blocchi liberi, ce ne sono {there}.',
    en: 'The targets want {wanted} loose blocks, there are {there}.',
  },
  'target-too-small': {
    de: '{what} ist zu klein für die beweglichen Blöcke.',
    fr: 'Trop petit pour les blocs libres : {what}.',
    it: 'Troppo piccolo per i blocchi liberi: {what}.',
    en: '{what} is too small for the loose blocks.',
  },
  'mover-still': {
    de: '{what} hat keinen Weg: Er steht still.',
    fr: '{what} n’a pas de trajet : il reste sur place.',
    it: '{what} non ha un tragitto: sta fermo.',
    en: '{what} has no way to go: it stands still.',
  },
  'block-inside': {
    de: '{what} steckt in etwas anderem: {other}.',
    fr: '{what} se trouve dans autre chose : {other}.',
    it: '{what} si trova dentro qualcos’altro: {other}.',
    en: '{what} stands inside something else: {other}.',
  },
  covered: {
    de: 'Hier liegen {count} gleiche {kinds} übereinander.',
    fr: 'Ici, {count} {kinds} identiques se superposent.',
    it: 'Qui {count} {kinds} uguali stanno nello stesso posto.',
    en: '{count} identical {kinds} lie on top of each other here.',
  },
};
const two: Texts = { de: 'zwei', fr: 'deux', it: 'due', en: 'Two' };

/** Whether a problem is worth a hint: a line that was drawn twice looks the same, and sensors read the same. */
export const isWorthTelling = ({ code, params }: RuleProblem): boolean =>
  !(code === 'covered' && params['kind'] === 'stroke');

/** A problem of a course as a sentence. */
export function problemWords({ code, params, ids }: RuleProblem, scene: Scene): string {
  const names = namesOf(scene);
  const nameOf = (id: unknown): string => (typeof id === 'string' ? (names.get(id) ?? '') : '');
  const kind = kindOf(params['kind']);
  return say(texts[code], {
    ...params,
    ...(params['count'] === 2 && code === 'covered' ? { count: say(two) } : {}),
    what: nameOf(params['id'] ?? ids[0]),
    other: nameOf(params['other']),
    kinds: kind === null ? '' : inSentence(say(kindTexts[kind].many)),
  });
}

/** A name inside a sentence: in German only an adjective before it begins with a small letter. */
function inSentence(name: string): string {
  const isSmall = shownLanguage() !== 'de' || name.includes(' ');
  return isSmall ? name.charAt(0).toLowerCase() + name.slice(1) : name;
}

function kindOf(value: unknown): SceneObject['type'] | null {
  return typeof value === 'string' && value in kindTexts ? (value as SceneObject['type']) : null;
}
