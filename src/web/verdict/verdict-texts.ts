import type { Texts } from '#core/texts';
import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/verdict';

/** The words of the verdict bar; they come with it. */
export const verdictTexts = {
  title: { de: 'Aufgabe', en: 'Task' },
  checkpoints: { de: 'Kontrollpunkte', en: 'Checkpoints' },
  target: { de: 'Ziel', en: 'Target' },
  targets: { de: 'Ziele', en: 'Targets' },
  blocks: { de: 'Blöcke im Ziel', en: 'Blocks delivered' },
  block: { de: 'Block im Ziel', en: 'Block delivered' },
  open: { de: 'offen', en: 'open' },
  done: { de: 'erreicht', en: 'reached' },
  ofMany: { de: '{done} von {of}', en: '{done} of {of}' },
  timeLeft: { de: 'noch {seconds} s', en: '{seconds} s left' },
  noTouch: { de: 'Nichts berühren', en: 'Touch nothing' },
  avoidZones: { de: 'Verbotene Felder meiden', en: 'Keep off the forbidden zones' },
  avoidSpikes: { de: 'Stacheln meiden', en: 'Keep off the spikes' },
  holdOut: { de: 'Durchhalten, bis die Zeit um ist', en: 'Hold out until the time is over' },
  passed: { de: 'Geschafft!', en: 'Well done!' },
  passedIn: { de: 'Aufgabe gelöst in {seconds} s.', en: 'Task done in {seconds} s.' },
  failed: { de: 'Nicht geschafft', en: 'Not yet' },
  failedAfter: { de: 'nach {seconds} s', en: 'after {seconds} s' },
  again: { de: 'Nochmals', en: 'Try again' },
  againLong: { de: 'Nochmals: alles zurück an den Start', en: 'Try again: everything back to the start' },
  showPlace: { de: 'Zeigen', en: 'Show' },
  showPlaceLong: { de: 'Zeigen, was im Weg war', en: 'Show what was in the way' },
  reached: { de: '{goal}: {done} von {of}.', en: '{goal}: {done} of {of}.' },
} as const satisfies Readonly<Record<string, Texts>>;

/** What happened, and what to do about it. */
export const reasonTexts: Readonly<Record<NonNullable<Verdict['reason']>, { what: Texts; todo: Texts }>> = {
  time: {
    what: { de: 'Die Zeit ist um.', en: 'The time is over.' },
    todo: { de: 'Fahr schneller oder kürze den Weg ab.', en: 'Drive faster or take a shorter way.' },
  },
  forbidden: {
    what: { de: 'Der Roboter ist auf ein verbotenes Feld gekommen.', en: 'The robot got onto a forbidden zone.' },
    todo: { de: 'Fahr in weiterem Bogen darum herum.', en: 'Drive around it in a wider arc.' },
  },
  spikes: {
    what: { de: 'Der Roboter hat Stacheln berührt.', en: 'The robot touched spikes.' },
    todo: { de: 'Bremse früher oder weiche aus.', en: 'Brake earlier or drive around them.' },
  },
  touched: {
    what: { de: 'Der Roboter hat {thing} berührt.', en: 'The robot touched {thing}.' },
    todo: { de: 'Bremse früher oder lenke früher ein.', en: 'Brake or turn earlier.' },
  },
};

/** What may be touched, in the accusative; `edge` is that of the arena. */
export const thingTexts: Readonly<Record<'edge' | 'other' | SceneObject['type'], Texts>> = {
  edge: { de: 'den Rand der Arena', en: 'the edge of the arena' },
  other: { de: 'etwas', en: 'something' },
  wall: { de: 'eine Wand', en: 'a wall' },
  block: { de: 'einen Block', en: 'a block' },
  'fixed-block': { de: 'einen festen Block', en: 'a fixed block' },
  spikes: { de: 'Stacheln', en: 'spikes' },
  mover: { de: 'ein bewegtes Hindernis', en: 'a moving obstacle' },
  stroke: { de: 'etwas', en: 'something' },
  target: { de: 'etwas', en: 'something' },
  checkpoint: { de: 'etwas', en: 'something' },
  forbidden: { de: 'etwas', en: 'something' },
  label: { de: 'etwas', en: 'something' },
};
