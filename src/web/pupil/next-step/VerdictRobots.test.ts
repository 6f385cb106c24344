// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import type { TaskRule } from '#scene/scene';
import type { RobotVerdict, Verdict } from '#simulation/task/verdict';

import { editingPage } from '../../app/testing/editing';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { newBoard } from '../several-devices/new-device';
import { verdictAtStart } from '#simulation/task/verdict-at-start';
import VerdictRobots from './VerdictRobots.vue';

const robot = (device: string, more: Partial<RobotVerdict>): RobotVerdict => ({
  ...{ device, state: 'failed', atMs: 1000, reason: null, by: null, place: null, touches: 0 },
  ...{ checkpoints: { passed: 0, of: 0 }, targets: { reached: 0, of: 1 } },
  ...more,
});

/** Text about Ada and Ben, who share a task: the rule, and the number and result of each. */
async function said(rule: TaskRule, robots: readonly RobotVerdict[], state: Verdict['state'] = 'open') {
  const page = await editingPage([]);
  page.work.addDevice({ ...newBoard(page), name: 'Ben' }, 'Ada');
  const verdict = { ...verdictAtStart(page.scene()), state, robots };
  const mounted = mountOn(page, VerdictRobots, { rule, verdict });
  return mounted.findAll('.goal, li').map((one) => textOf(one.element));
}

describe('a task that several robots share', () => {
  it('says how, and of each robot for which it has ended, how it did', async () => {
    const robots = [robot('Ada', { state: 'open', atMs: null }), robot('Ben', { reason: 'left' })];
    expect(await said('ring', robots)).toEqual(['im Ring bleiben', '2Ben aus dem Ring']);
  });

  it('says who has won, and who came too late', async () => {
    const robots = [robot('Ada', { reason: 'beaten' }), robot('Ben', { state: 'passed' })];
    expect(await said('first', robots, 'passed')).toEqual(['1Ada zu spät', '2Ben gewinnt']);
  });

  it('says who got away', async () => {
    const robots = [robot('Ada', { reason: 'time' }), robot('Ben', { state: 'passed' })];
    expect(await said('catch', robots, 'failed')).toEqual(['1Ada zu spät', '2Ben entkommen']);
  });

  const alone = [robot('Ada', { state: 'open', atMs: null })];

  it('asks for a second robot where there is one alone', async () => {
    expect(await said('first', alone)).toEqual(['wer zuerst da ist, gewinnt', 'Dafür braucht es zwei Roboter.']);
  });

  it('does not ask for it where one can do the task, too', async () => {
    expect(await said('all', alone)).toEqual(['alle kommen an']);
  });
});
