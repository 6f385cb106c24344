import { beforeAll, describe, expect, it } from 'vitest';

import { loadTexts } from '../../kit/i18n';
import { nextStep, type NextStep, type StepFacts, type StepTask } from './next-step';

beforeAll(() => loadTexts('de'));

const facts: StepFacts = {
  ...{ mode: 'drive', isGreeted: false, isPhone: false, drive: 'before', seconds: '3.2' },
  ...{ error: null, task: null, course: '80 × 50 cm · 8 Dinge · 1 Problem', waiting: '' },
};
const mission: StepTask = {
  ...{ kind: 'mission', state: 'open', told: '', wanted: 'Lies die Aufgabe, dann lass ihn fahren.', news: '' },
  ...{
    isEarly: false,
    missing: 'Noch offen: Ziel.',
    hints: { open: 0, all: 2 },
    own: { open: 0, all: 0 },
    next: null,
    isHandedIn: false,
  },
};
const inTask = (task: Partial<StepTask>, more: Partial<StepFacts> = {}): Partial<StepFacts> => ({
  drive: 'drives',
  ...more,
  task: { ...mission, ...task },
});
const passed = { state: 'passed', told: 'Aufgabe gelöst in 1.6 s.' } as const;
const failed = { state: 'failed', told: 'Der Roboter hat eine Wand berührt.' } as const;

/** The bar in one line: kind, ground, title, reason, and its button's action and words. */
function inALine({ kind, tone, title, reason, button }: NextStep): string {
  const pressed = button === null ? '–' : `${button.action}${button.isInk ? '!' : ''} ${button.text}`;
  return [kind, tone, title, reason, pressed].join(' | ');
}

const states: readonly (readonly [when: string, facts: Partial<StepFacts>, bar: string])[] = [
  [
    'a first visit',
    { isGreeted: true, task: mission },
    'press | plain | Drücke oben auf «Simulieren» | Dein Programm fährt den Roboter eine Sekunde vorwärts. | –',
  ],
  ['an empty arena', {}, 'ready | plain | Bereit | Mit «Simulieren» fährt der Roboter los. | –'],
  [
    'a task not yet tried',
    { task: mission },
    'ready | plain | Bereit | Lies die Aufgabe, dann lass ihn fahren. | run! Los geht’s',
  ],
  ['driving', inTask({ news: 'Kontrollpunkte: 1 von 3.' }), 'drives | plain |  | Kontrollpunkte: 1 von 3. | –'],
  [
    'a checkpoint that came too early',
    inTask({ news: 'Kontrollpunkt 2 kam vor 1.', isEarly: true }),
    'drives | notYet |  | Kontrollpunkt 2 kam vor 1. | –',
  ],
  ['a pause', inTask({}, { drive: 'paused' }), 'paused | plain | Pause |  | –'],
  [
    'a program that ended before the goal',
    inTask({}, { drive: 'over' }),
    'notYet | notYet | Noch nicht geschafft | Noch offen: Ziel. | hint Tipp ansehen',
  ],
  ['a failed task', inTask(failed), `notYet | notYet | Noch nicht geschafft | ${failed.told} | hint Tipp ansehen`],
  [
    'a failed task whose first hint was read',
    inTask({ ...failed, hints: { open: 1, all: 2 } }),
    `notYet | notYet | Noch nicht geschafft | ${failed.told} | hint Tipp 2 ansehen`,
  ],
  [
    'a failed task without a further hint',
    inTask({ ...failed, hints: { open: 2, all: 2 } }),
    `notYet | notYet | Noch nicht geschafft | ${failed.told} | –`,
  ],
  [
    'a stop by hand',
    inTask({}, { drive: 'stopped' }),
    'stopped | plain | Angehalten | Nach 3.2 s. Noch offen: Ziel. | –',
  ],
  ['a program without a task that ended', { drive: 'over' }, 'over | plain | Programm beendet | Nach 3.2 s. | –'],
  [
    'a task done by hand',
    inTask({ state: 'helped', news: 'Mit Hilfe der Hand', told: 'Das zählt nicht.' }),
    'helped | notYet | Mit Hilfe der Hand | Das zählt nicht. | again Nochmals',
  ],
  [
    'a teacher’s task that lacks something',
    inTask({ kind: 'given', state: 'lacking', told: 'Es fehlt eine Schleife.' }),
    'notYet | notYet | Noch nicht geschafft | Es fehlt eine Schleife. | hint Tipp ansehen',
  ],
  [
    'a teacher’s task that is being checked',
    inTask({ kind: 'given', state: 'checking', told: 'Der Rest wird geprüft …' }),
    'checking | plain | Ziel erreicht | Der Rest wird geprüft … | –',
  ],
  [
    'a mission that was passed, before the next one is known',
    inTask(passed),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | –',
  ],
  [
    'a mission that was passed',
    inTask({ ...passed, next: 'mission' }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | mission! Nächste Mission',
  ],
  [
    'the last mission, with stars left',
    inTask({ ...passed, next: 'stars' }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | stars! Sterne holen',
  ],
  [
    'the last mission, with all stars',
    inTask({ ...passed, next: 'missions' }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | missions Alle Missionen',
  ],
  [
    'a task that was handed out, and passed',
    inTask({ ...passed, kind: 'given', next: 'mission' }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | hand-in! Abgeben',
  ],
  [
    'a task that was handed in',
    inTask({ ...passed, kind: 'given', isHandedIn: true }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | hand-in Nochmals abgeben',
  ],
  [
    'a course of one’s own that was passed',
    inTask({ ...passed, kind: 'own' }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | again Nochmals',
  ],
  [
    'an error',
    { drive: 'over', error: { line: 3 }, task: mission },
    'error | error | Zeile 3 hat einen Fehler | Was hilft, steht in der Konsole. | –',
  ],
  [
    'an error on a phone',
    { drive: 'over', error: { line: 3 }, task: { ...mission, ...failed }, isPhone: true },
    'error | error | Zeile 3 hat einen Fehler | Unter dem Programm steht, wie du ihn behebst. | change! Ändern',
  ],
  [
    'an error without a line',
    { drive: 'over', error: { line: null } },
    'error | error | Das Programm hat einen Fehler | Was hilft, steht in der Konsole. | –',
  ],
  [
    'an error after the goal',
    inTask({ ...passed, kind: 'own' }, { error: { line: 3 } }),
    'done | done | Geschafft! | Aufgabe gelöst in 1.6 s. | again Nochmals',
  ],
  [
    'building',
    { mode: 'build', task: mission },
    'build | plain | Gesichert | 80 × 50 cm · 8 Dinge · 1 Problem | try! Ausprobieren',
  ],
  [
    'building after a run',
    { mode: 'build', ...inTask(passed, { drive: 'paused' }) },
    'build | plain | Gesichert | 80 × 50 cm · 8 Dinge · 1 Problem | try! Ausprobieren',
  ],
  [
    'a change that waits for the next start',
    { ...inTask({}), waiting: 'Wand: gilt erst, wenn du neu startest.' },
    'waiting | plain | Gilt ab dem nächsten Start | Wand: gilt erst, wenn du neu startest. | restart Zurück zum Start',
  ],
];

describe('the next step', () => {
  it.each(states)('after %s', (_, given, bar) => {
    expect(inALine(nextStep({ ...facts, ...given }))).toBe(bar);
  });
});
