// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { newBoard } from '../several-devices/new-device';
import DeviceMenu from './DeviceMenu.vue';

describe('the button of the device', () => {
  afterEach(() => history.replaceState(null, '', '/'));

  it('is called by robot and microcomputer, of several devices by their number as well', async () => {
    const page = createPage();
    page.settings.change({ device: 'microbit-v2', robot: 'none' });
    mountOn(page, DeviceMenu);
    named('Gerät: micro:bit V2');
    page.settings.change({ device: 'calliope-mini-2', robot: 'maqueen-lite' });
    await nextTick();
    expect(named('Gerät: Maqueen Lite, Calliope mini 1/2').title).toBe('Gerät wählen');
    page.work.addDevice(newBoard(page), 'Roboter');
    await nextTick();
    named('Gerät: 2 Geräte, Calliope mini 1/2');
  });

  it('opens the panel, and from it the gallery in the panel’s place', async () => {
    const page = createPage();
    mountOn(page, DeviceMenu);
    const button = document.querySelector<HTMLElement>('[data-testid="device"]')!;
    expect(button.getAttribute('aria-expanded')).toBe('false');
    button.click();
    await vi.waitFor(() => named('Alle Einstellungen'), 20_000);
    named('Alle Einstellungen').click();
    await nextTick();
    expect(button.getAttribute('aria-expanded')).toBe('true');
    named('Roboter-Galerie').click();
    await nextTick();
    expect(button.getAttribute('aria-expanded')).toBe('false');
    expect(page.router.page.value).toEqual({ name: 'robots', id: null });
    expect(document.activeElement).toBe(button);
  });
});
