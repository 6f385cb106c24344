// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { idealTraits } from '#robots/traits';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import type { Settings } from '../../session/work/settings/settings';
import DeviceList from './DeviceList.vue';

/** The panel of the device for a program that says nothing of it, with these settings. */
function panel(settings: Partial<Settings> = {}) {
  const page = createPage();
  const files = [{ name: 'main.py', text: 'from microbit import *\n' }];
  page.work.openProject({ files, scene: page.work.scene.value, course: null }, null);
  page.settings.change(settings);
  let galleries = 0;
  const mounted = mountOn(page, DeviceList, { onLeave: () => (galleries += 1) });
  const choice = (id: string) => {
    const label = mounted.get(`[data-testid="${id}"]`);
    return {
      label,
      input: label.get<HTMLInputElement>('input'),
      text: () => label.findAll('.text').map((it) => it.text())[0] ?? '',
    };
  };
  const choose = async (id: string) => {
    await choice(id).input.setValue();
    await nextTick();
  };
  return { page, mounted, choice, choose, galleries: () => galleries };
}

describe('the panel of the device', () => {
  it('has a group for the microcomputer, its firmware and the robot', () => {
    const { mounted } = panel({ device: 'microbit-v2', robot: 'none' });
    expect(mounted.attributes('aria-label')).toBe('Gerät');
    expect(mounted.findAll('legend').map((it) => it.text())).toEqual(['Mikrocomputer', 'Firmware', 'Roboter']);
  });

  it('marks what is chosen', () => {
    const { choice } = panel({ device: 'calliope-mini-3', robot: 'none' });
    expect(choice('board-calliope-mini-3').input.element.checked).toBe(true);
    expect(choice('board-microbit-v2').input.element.checked).toBe(false);
    expect(choice('robot-none').input.element.checked).toBe(true);
  });

  it('says which microcomputer the program leads to where that is left to it', async () => {
    const { choice, choose } = panel({ device: 'auto', robot: 'none' });
    expect(choice('board-auto').text()).toBe('Nach dem Programm: micro:bit V2');
    await choose('board-calliope-mini-3');
    expect(choice('board-auto').text()).toBe('');
  });

  it('chooses a microcomputer', async () => {
    const { page, choose } = panel({ device: 'auto', robot: 'none' });
    await choose('board-calliope-mini-3');
    expect(page.settings.current.value.device).toBe('calliope-mini-3');
    expect(page.notices.current.value).toBeNull();
  });

  it('says on which board each robot drives', () => {
    const { choice } = panel();
    expect(choice('robot-maqueen-lite').text()).toBe('auf micro:bit V2');
  });

  it('puts the arena away without a robot; a robot brings it back', async () => {
    const { page, choose } = panel({ device: 'microbit-v2', robot: 'maqueen-lite', showArena: true });
    await choose('robot-none');
    expect(page.settings.current.value).toMatchObject({ robot: 'none', showArena: false });
    await choose('robot-maqueen-lite');
    expect(page.settings.current.value).toMatchObject({ robot: 'maqueen-lite', showArena: true });
  });

  it('ends a run that is under way, and says why', async () => {
    const { page, choose } = panel({ device: 'microbit-v2', robot: 'none' });
    await startRun(page);
    await choose('board-calliope-mini-3');
    expect(page.notices.current.value).toMatchObject({ kind: 'info', key: 'notice.deviceChanged' });
    await page.run.stop();
    expect(page.run.isActive.value).toBe(false);
  });

  it('chooses another firmware of the board', async () => {
    const { page, mounted, choice, choose } = panel({ device: 'microbit-v2', robot: 'none' });
    const all = mounted.findAll('[data-testid^="firmware-"]');
    expect(all.length).toBeGreaterThan(1);
    const last = all.at(-1)!.attributes('data-testid')!;
    expect(choice(last).input.element.checked).toBe(false);
    await choose(last);
    expect(page.settings.current.value.firmware).toBe(last.replace('firmware-', ''));
    expect(choice(last).input.element.checked).toBe(true);
  });

  it('says that robot and board do not fit, and plugs them in with one press', async () => {
    const { page, mounted } = panel({ device: 'calliope-mini-3', robot: 'maqueen-lite' });
    expect(textOf(mounted.get('[role="status"]').element)).toContain(
      'Hier steckt ein Calliope mini 3: Der Roboter hört nichts.',
    );
    named('Umstecken').click();
    await nextTick();
    expect(page.settings.current.value.device).not.toBe('calliope-mini-3');
    expect(mounted.find('[data-testid="misplugged"]').exists()).toBe(false);
  });

  it('leads to the gallery of the robots', () => {
    const { galleries } = panel();
    named('Roboter-Galerie').click();
    expect(galleries()).toBe(1);
  });
});

describe('what is set up about a robot', () => {
  it('is there for a robot only', async () => {
    const { mounted, choose } = panel({ device: 'microbit-v2', robot: 'maqueen-lite' });
    expect(mounted.get('.options h2').text()).toBe('Maqueen Lite einrichten');
    expect(mounted.find('[data-testid="reality"]').exists()).toBe(true);
    await choose('robot-none');
    expect(mounted.find('.options h2').exists()).toBe(false);
    expect(mounted.find('[data-testid="reality"]').exists()).toBe(false);
  });

  it('is changed by choosing, and put back with one press', async () => {
    const { page, mounted } = panel({ device: 'microbit-v2', robot: 'maqueen-lite' });
    const select = mounted.get<HTMLSelectElement>('[data-testid^="option-"]');
    const before = select.element.value;
    const other = [...select.element.options].find(({ value }) => value !== before)!.value;
    expect(mounted.find('[data-testid="options-reset"]').exists()).toBe(false);
    await select.setValue(other);
    const id = select.attributes('data-testid')!.replace('option-', '');
    expect(page.settings.current.value.robotOptions['maqueen-lite']).toEqual({ [id]: other });
    named('Zurücksetzen').click();
    await nextTick();
    expect(select.element.value).toBe(before);
    expect(mounted.find('[data-testid="options-reset"]').exists()).toBe(false);
  });

  it('folds what only people ask for who know the series, until some of it is changed', async () => {
    const { mounted } = panel({ device: 'microbit-v2', robot: 'maqueen-plus-v2' });
    const experts = mounted.get<HTMLDetailsElement>('[data-testid="experts"]');
    expect(textOf(experts.get('summary').element)).toBe('Für Kenner');
    const ids = experts.findAll('select').map((it) => it.attributes('data-testid'));
    expect(ids).toEqual(['version', 'analogOrder', 'analogPolarity', 'echo', 'incidence'].map((id) => `option-${id}`));
    expect(experts.element.open).toBe(false);
    await experts.get('[data-testid="option-incidence"]').setValue('25');
    expect(experts.element.open).toBe(true);
  });

  it('has a name at every choice', () => {
    const { mounted } = panel({ device: 'microbit-v2', robot: 'maqueen-lite' });
    const names = mounted.findAll('label.option .name').map((it) => it.text());
    expect(names.length).toBeGreaterThan(0);
    expect(names.every((name) => name !== '')).toBe(true);
  });

  it('ends a run that is under way, and says why', async () => {
    const { page, mounted } = panel({ device: 'microbit-v2', robot: 'maqueen-lite' });
    await startRun(page);
    const select = mounted.get<HTMLSelectElement>('[data-testid^="option-"]');
    await select.setValue([...select.element.options].find(({ value }) => value !== select.element.value)!.value);
    expect(page.notices.current.value).toMatchObject({ key: 'notice.robotChanged' });
  });
});

describe('how real the robot is', () => {
  const robot = { device: 'microbit-v2', robot: 'maqueen-lite' };
  const slide = async (mounted: ReturnType<typeof panel>['mounted'], value: number) =>
    mounted.get('[data-testid="reality"] input').setValue(String(value));

  it('is ideal at first; then all robots are alike and have no number', () => {
    const { mounted } = panel({ ...robot, reality: 0 });
    expect(mounted.get('[data-testid="reality"] input').attributes('aria-valuetext')).toBe('ideal');
    expect(mounted.get('.reality > small').text()).toBe('Beide Motoren sind gleich stark, die Sensoren messen genau.');
    expect(mounted.find('[data-testid="seed"]').exists()).toBe(false);
  });

  it.each([
    [0.25, 'fast neu'],
    [0.5, 'eingefahren'],
    [0.75, 'oft gebraucht'],
    [1, 'wie ein alter Schulroboter'],
  ])('at %s is called %s', async (value, name) => {
    const { page, mounted } = panel({ ...robot, reality: 0 });
    await slide(mounted, value);
    expect(page.settings.current.value.reality).toBe(value);
    expect(mounted.get('[data-testid="reality"] input').attributes('aria-valuetext')).toBe(name);
    expect(mounted.get('.reality > small').text()).toContain('Ein Motor zieht stärker');
  });

  it('takes the robot whose number is typed', async () => {
    const { page, mounted } = panel({ ...robot, reality: 1, seed: 3 });
    await mounted.get('[data-testid="seed"] input').setValue('42');
    expect(page.settings.current.value.seed).toBe(42);
    expect(mounted.get('[data-testid="seed"] [role="status"]').text()).toBe('Roboter Nr. 42');
  });

  it.each(['0', '-1', '1.5', '', '99999999999'])(
    'leaves its number where “%s” is typed, which is none',
    async (typed) => {
      const { page, mounted } = panel({ ...robot, reality: 1, seed: 3 });
      const field = mounted.get<HTMLInputElement>('[data-testid="seed"] input');
      await field.setValue(typed);
      expect(page.settings.current.value.seed).toBe(3);
      expect(field.element.value).toBe('3');
    },
  );

  it('takes the next robot with one press, after the last the first', () => {
    const { page, mounted } = panel({ ...robot, reality: 1, seed: 3 });
    named('Anderer Roboter').click();
    expect(page.settings.current.value.seed).toBe(4);
    const last = Number(mounted.get('[data-testid="seed"] input').attributes('max'));
    page.settings.change({ seed: last });
    named('Anderer Roboter').click();
    expect(page.settings.current.value.seed).toBe(1);
  });

  it('says that one’s own robot drives, and stops saying so when it shall not', async () => {
    const measured = {
      drives: { slow: null, usual: null, fast: null },
      turnDeg: 590,
      echoesMm: [null, null],
      line: {},
    } as const;
    const myRobot = { name: 'Röbi', robot: 'maqueen-lite', used: true, measured, traits: idealTraits };
    const { page, mounted, choose } = panel({ device: 'auto', robot: 'maqueen-lite', myRobot });
    expect(mounted.get('.reality small').text()).toContain('Er fährt wie Röbi.');
    await mounted.get('[data-testid="my-robot-used"]').setValue(false);
    expect(page.settings.current.value.myRobot?.used).toBe(false);
    expect(mounted.get('.reality small').text()).toContain('Beide Motoren sind gleich stark');
    await choose('robot-maqueen-plus-v2');
    expect(mounted.find('[data-testid="my-robot-used"]').exists()).toBe(false);
  });
});
