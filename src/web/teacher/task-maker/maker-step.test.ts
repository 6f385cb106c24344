import { describe, expect, it } from 'vitest';
import type { CheckResult, WorldResult } from '#check/result';
import { plainWorld } from '#check/task/task';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { makerStep, type MakerState } from './maker-step';

const solution = [{ name: 'main.py', text: 'forward()\n' }];
const hidden = { ...plainWorld, id: '2', hidden: true } as const;
const task = { ...taskWith(sceneWith([targetAt(700, 450)])), solution, worlds: [plainWorld, hidden] } as const;
const worldOf = (id: string, passed: boolean): WorldResult => ({
  ...{ id, hidden: id !== 'visible', passed, atMs: 1000, touches: 0, held: [], missed: {}, hash: id },
  ...{ trail: [], trailMs: [], reason: passed ? null : { code: 'open', params: {} } },
});
const resultOf = (...passed: readonly boolean[]): CheckResult => ({
  ...{ passed: passed.every(Boolean), points: 1, stars: null, checks: [], remarks: [], twin: '' },
  worlds: passed.map((one, place) => worldOf(place === 0 ? 'visible' : '2', one)),
});
const state = (part: Partial<MakerState>): MakerState => ({
  ...{ task, lacksGoals: false, result: resultOf(true, true), isOld: false, equals: [] },
  ...part,
});

describe('the next step in making a task', () => {
  it('is a goal, then a solution, then its run', () => {
    const without = { ...task, solution: null };
    expect(makerStep(state({ lacksGoals: true, task: without })).kind).toBe('goal');
    expect(makerStep(state({ task: without, result: null })).kind).toBe('write');
    expect(makerStep(state({ result: null })).kind).toBe('runs');
    expect(makerStep(state({ isOld: true })).kind).toBe('runs');
  });

  it('is the first world in which the solution does not pass, else what its text lacks', () => {
    expect(makerStep(state({ result: resultOf(true, false) }))).toMatchObject({ kind: 'fails', place: 1, reason: { code: 'open' } }); // prettier-ignore
    const reason = { code: 'loop', params: {} } as const;
    const lacks = { ...resultOf(true, true), passed: false, checks: [{ id: 'loop', passed: false, reason }] };
    expect(makerStep(state({ result: lacks }))).toEqual({ kind: 'fails', place: null, reason });
  });

  it('is a start program that gives the solution away, then a world that tests nothing new', () => {
    const equals = [{ id: '2', other: '1' }];
    expect(makerStep(state({ task: { ...task, solution: task.project.files }, equals })).kind).toBe('same');
    expect(makerStep(state({ equals }))).toEqual({ kind: 'equal', place: 1, world: { id: '2', other: '1' } });
  });

  it('is to hand it out, with a word if no world is hidden', () => {
    expect(makerStep(state({})).kind).toBe('ready');
    expect(makerStep(state({ task: { ...task, worlds: [plainWorld] }, result: resultOf(true) })).kind).toBe('visible');
  });
});
