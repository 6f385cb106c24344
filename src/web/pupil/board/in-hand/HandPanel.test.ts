// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { remoteKeys } from '#devices/nec-remote';
import { mountOn } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { startRun } from '../../../app/testing/run';
import HandPanel from './HandPanel.vue';
import StickPad from './StickPad.vue';

describe('the panel of what is in the hand', () => {
  it('has the 21 keys of the remote control in their order, each with its code', () => {
    const mounted = mountOn(createPage(), HandPanel);
    const keys = mounted.findAll('.remote button');
    expect(keys.map((key) => key.attributes('data-testid'))).toEqual(remoteKeys.map(([name]) => `remote-${name}`));
    expect(keys[8]?.attributes('aria-label')).toBe('Pfeil nach oben, sendet 10');
  });

  it('says instead that nothing receives it, where no robot has a receiver', () => {
    const page = createPage();
    page.settings.change({ robot: 'callibot' });
    const mounted = mountOn(page, HandPanel);
    expect(mounted.find('.remote').exists()).toBe(false);
    expect(mounted.get('[data-testid=remote-unheard]').text()).toMatch(/Infrarotempfänger/);
  });

  it('plugs a micro:bit without a robot into a gamepad, and takes it out again', async () => {
    const page = createPage();
    page.settings.change({ robot: 'none' });
    const mounted = mountOn(page, HandPanel);
    expect(mounted.find('.gamepad').exists()).toBe(false);
    const box = mounted.get('[data-testid=plug-gamepad]');
    await box.setValue(true);
    expect(page.settings.current.value.robotOptions).toEqual({ none: { inHand: 'gamepad' } });
    expect(mounted.findAll('.gamepad .keys button').map((key) => key.text())).toEqual([
      ...['DGelb', 'ERot', 'CGrün', 'FBlau'],
    ]);
    await box.setValue(false);
    await nextTick();
    expect(mounted.find('.gamepad').exists()).toBe(false);
  });

  it('tells the keys of the keyboard that do something: those of the gamepad only while there is one', async () => {
    const robot = createPage();
    const beside = mountOn(robot, HandPanel);
    await startRun(robot);
    expect(beside.get('.hint').text()).toBe('Tippen, oder Tasten der Tastatur: Pfeile, 0–9.');
    const page = createPage();
    page.settings.change({ robot: 'none' });
    const mounted = mountOn(page, HandPanel);
    await mounted.get('[data-testid=plug-gamepad]').setValue(true);
    await startRun(page);
    expect(mounted.get('.hint').text()).toBe('Tippen, oder Tasten der Tastatur: Pfeile, C, D, E, F, Z.');
  });

  it('has no gamepad for a board that is on a robot', () => {
    const mounted = mountOn(createPage(), HandPanel);
    expect(mounted.find('[data-testid=plug-gamepad]').exists()).toBe(false);
  });

  it('has a picture of the vibration, which is told as well, while the motor hums', () => {
    const waves = (vibrates: boolean) =>
      mountOn(createPage(), StickPad, { stick: { x: 0, y: 0 }, pressed: false, vibrates }).get('.waves');
    expect(waves(false).attributes('aria-hidden')).toBe('true');
    expect(waves(true).attributes()).toMatchObject({ 'aria-hidden': 'false', 'aria-label': 'Das Gamepad vibriert' });
  });
});
