import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import type { PointLine } from '#rescue-line/points';
import type { Verdict } from '#simulation/task/verdict';
import { verdictAtStart } from '#simulation/task/verdict-at-start';
import { verdictLines } from './verdict-lines';

describe('the line about the task', () => {
  const open: Verdict = {
    ...verdictAtStart(defaultScene()),
    ...{ checkpoints: { passed: 1, of: 3 }, targets: { reached: 0, of: 1 } },
  };
  const failed = { ...open, state: 'failed', atMs: 4200 } as const;

  it.each([
    [{ ...open, state: 'passed', atMs: 12_400 } as const, 'Task: passed after 12.4 s.'],
    [
      { ...open, state: 'passed', atMs: 12_400, help: ['hand'] } as const,
      'Task: passed after 12.4 s, with help by hand.',
    ],
    [
      { ...open, state: 'helped', atMs: 12_400, help: ['hand', 'edits'] } as const,
      'Task: done after 12.4 s, with help by hand, with a course that was changed: does not count as passed.',
    ],
    [
      { ...open, early: { id: 'c', number: 2, before: 1 } } as const,
      'Task: not done (1 of 3 checkpoints, 0 of 1 target); checkpoint 2 came before checkpoint 1.',
    ],
    [
      { ...failed, reason: 'time', early: { id: 't', number: 0, before: 3 } } as const,
      'Task: failed after 4.2 s: the time was over (1 of 3 checkpoints, 0 of 1 target); a target came before checkpoint 3.',
    ],
    [{ ...open, state: 'passed', atMs: 12_400, stars: 2 } as const, 'Task: passed after 12.4 s, 2 of 3 stars.'],
    [open, 'Task: not done (1 of 3 checkpoints, 0 of 1 target).'],
    [
      { ...failed, reason: 'time' } as const,
      'Task: failed after 4.2 s: the time was over (1 of 3 checkpoints, 0 of 1 target).',
    ],
    [
      { ...failed, reason: 'spikes', by: 'spikes-1' } as const,
      'Task: failed after 4.2 s: the robot touched the spikes “spikes-1”.',
    ],
    [{ ...failed, reason: 'touched' } as const, 'Task: failed after 4.2 s: the robot touched the edge of the arena.'],
    [
      { ...failed, reason: 'forbidden', by: 'no' } as const,
      'Task: failed after 4.2 s: the robot came into the forbidden zone “no”.',
    ],
  ])('says how it came out', (verdict, line) => {
    expect(verdictLines(verdict, 'en')).toEqual([line]);
  });

  it('adds the score sheet of a line that is scored', () => {
    const line = (what: PointLine['what'], tile: number, points: number, state: PointLine['state']): PointLine => ({
      ...{ what, tile, count: 1, points, state },
    });
    const lines = [line('gap', 1, 10, 'earned'), line('tiles', 3, 0, 'missed'), line('exit', 6, 60, 'open')];
    const points = { rules: 'line-2025', score: 21, lines, factor: 1.4, lacks: 3, section: 2, attempt: 1, tile: 3 } as const;
    expect(verdictLines({ ...open, points }, 'en').slice(1)).toEqual([
      'Points: 21 (Rescue Line 2025). Lacks of progress: 3; section 2, try 1.',
      '  Gaps on tile 2 (1): 10',
      '  1 tiles up to tile 4: passed over',
      '  Stop at the end: 60 still to be had',
      '  Factor for victims: 1.4',
    ]);
  }); // prettier-ignore

  it('speaks the reader’s language, all of it', () => {
    const late = { ...failed, reason: 'time', help: ['hand'], early: { id: 'c', number: 2, before: 1 } } as const;
    expect(verdictLines(late, 'de')).toEqual([
      'Aufgabe: nicht bestanden nach 4.2 s, mit Hilfe der Hand: Die Zeit war um (1 von 3 Kontrollpunkten, 0 von 1 Ziel); Kontrollpunkt 2 kam vor Kontrollpunkt 1.',
    ]);
    expect(verdictLines({ ...open, state: 'passed', atMs: 12_400, stars: 2 }, 'fr')).toEqual([
      'Tâche\u202f: réussie après 12.4 s, 2 étoiles sur 3.',
    ]);
    expect(verdictLines(open, 'it')).toEqual([
      'Compito: non ancora riuscito (punti di controllo: 1 su 3, traguardo: 0 su 1).',
    ]);
  });

  it('is followed by a line for each robot that shares the task', () => {
    const robot = { state: 'failed', atMs: 4200, by: null, place: null, touches: 0 } as const;
    const progress = { checkpoints: { passed: 1, of: 3 }, targets: { reached: 0, of: 1 } };
    const robots = [
      { ...robot, ...progress, device: 'Ada', state: 'passed', reason: null },
      { ...robot, ...progress, device: 'Ben', reason: 'beaten' },
      { ...robot, ...progress, device: 'Cem', reason: 'touched', by: 'w' },
      { ...robot, ...progress, device: 'Dan', state: 'open', atMs: null, reason: null },
    ] as const;
    expect(verdictLines({ ...open, state: 'passed', atMs: 4200, robots }, 'en')).toEqual([
      'Task: passed after 4.2 s.',
      '  Ada: passed after 4.2 s',
      '  Ben: failed after 4.2 s: another one was first',
      '  Cem: failed after 4.2 s: the robot touched “w”',
      '  Dan: not done (1 of 3 checkpoints, 0 of 1 target)',
    ]);
  });

  it('is left out where there is no task', () => {
    expect(verdictLines(null, 'en')).toEqual([]);
  });
});
