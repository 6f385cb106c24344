// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { inputsOf, show, startRun } from '../../../app/testing/run';
import RadioPanel from './RadioPanel.vue';

const on = { radio: { on: true, group: 7, channel: 42 } };
/** The bytes of a text as `radio.send` puts them on the air. */
const packet = (text: string, timeUs = 0) => ({
  timeUs,
  group: 7,
  bytes: [1, 0, 1, ...new TextEncoder().encode(text)],
});

/** The list follows ten times a second. */
const settle = async (): Promise<void> => {
  vi.advanceTimersByTime(200);
  await nextTick();
};
beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

/** The panel of the radio, in a run whose program has switched its radio on, or not. */
async function panel(picture: Parameters<typeof show>[1] = on) {
  const page = createPage();
  const mounted = mountOn(page, RadioPanel);
  await startRun(page);
  await show(page, picture);
  const type = async (text: string) => mounted.get('input').setValue(text);
  const send = async (text: string) => {
    await type(text);
    await mounted.get('form').trigger('submit');
    await settle();
  };
  const entries = () => mounted.findAll('li').map((it) => textOf(it.element));
  return { page, mounted, type, send, entries };
}

describe('the radio of the program', () => {
  it('says that there was no run yet, that it is off, or its group and channel', async () => {
    const page = createPage();
    const mounted = mountOn(page, RadioPanel);
    const tags = () => mounted.findAll('.tag').map((it) => it.text());
    expect(tags()).toEqual(['Noch kein Lauf']);
    await startRun(page);
    await show(page, {});
    expect(tags()).toEqual(['Funk ist aus']);
    await show(page, on);
    expect(tags()).toEqual(['Gruppe 7', 'Kanal 42']);
  });

  it('says of messages that are left after a reset that they are of the last run', async () => {
    const { page, mounted, entries } = await panel();
    page.radio.take([packet('hi')], 0);
    await settle();
    page.say({ type: 'stopped' });
    await page.run.reset();
    await settle();
    expect(entries()).toHaveLength(1);
    expect(mounted.get('.tag').text()).toBe('Vom letzten Lauf');
  });

  it('says what will stand there while there is no message', async () => {
    const { mounted } = await panel();
    expect(textOf(mounted.get('.panel-empty').element)).toContain(
      'Was dein Programm mit radio.send() funkt, steht hier.',
    );
    expect((named('Nachrichten leeren') as HTMLButtonElement).disabled).toBe(true);
  });

  it('lists what the program sends with its simulated time', async () => {
    const { page, entries } = await panel();
    page.radio.take([packet('hallo', 61_200_000)], 0);
    await settle();
    expect(entries()).toEqual(['01:01.2Programm →hallo']);
  });

  it('writes bytes that are no text in hexadecimal', async () => {
    const { page, mounted } = await panel();
    page.radio.take([{ timeUs: 0, group: 7, bytes: [0xca, 0xfe] }], 0);
    await settle();
    const message = mounted.get('.message');
    expect(message.classes()).toContain('bytes');
    expect(message.text().toLowerCase().replace(/\s/g, '')).toBe('cafe');
  });

  it('says that older messages are left out', async () => {
    const { page, entries } = await panel();
    page.radio.take([packet('neu')], 3);
    await settle();
    expect(entries()[0]).toBe('Ältere Nachrichten sind weggelassen.');
  });

  it('can be emptied', async () => {
    const { page, mounted } = await panel();
    page.radio.take([packet('hallo')], 0);
    await settle();
    named('Nachrichten leeren').click();
    expect(page.radio.entries.value).toEqual([]);
    expect(mounted.find('form').exists()).toBe(true);
  });
});

describe('a message to the program', () => {
  it('is sent, listed as received, and the field is empty for the next one', async () => {
    const { page, mounted, send, entries } = await panel();
    await send('links');
    expect(inputsOf(page)).toEqual([{ type: 'radio', text: 'links' }]);
    expect(mounted.get<HTMLInputElement>('input').element.value).toBe('');
    expect(entries()[0]).toContain('→ Programmlinks');
    expect(mounted.find('.lost').exists()).toBe(false);
  });

  it('is lost while the program’s radio is off, and that is said before and after', async () => {
    const { page, mounted, send } = await panel({});
    expect(mounted.get('.hint').text()).toBe('Der Funk des Programms ist aus: radio.on() schaltet ihn ein.');
    await send('links');
    expect(inputsOf(page)).toHaveLength(1);
    expect(mounted.get('.lost').text()).toBe('nicht empfangen: Funk ist aus');
  });

  it('is none without any letter', async () => {
    const { page, send } = await panel();
    await send('');
    expect(inputsOf(page)).toEqual([]);
  });

  it('fits as it is with 29 bytes, and needs a longer packet with 30: 33', async () => {
    const { mounted, type } = await panel();
    await type('x'.repeat(29));
    expect(mounted.find('.hint').exists()).toBe(false);
    await type('x'.repeat(30));
    expect(mounted.get('.hint').text()).toBe('30 Bytes: Mehr als 29 brauchen radio.config(length=33).');
    expect(mounted.get('input').attributes('aria-describedby')).toBe(mounted.get('.hint').attributes('id'));
  });

  it('counts bytes, not letters: 15 ä are 30', async () => {
    const { mounted, type } = await panel();
    await type('ä'.repeat(15));
    expect(mounted.get('.hint').text()).toContain('30 Bytes');
  });

  it('is not sent with more than 248 bytes and stays in the field', async () => {
    const { page, mounted, send } = await panel();
    const long = 'ä'.repeat(125);
    await send(long);
    expect(mounted.get('.hint').text()).toBe('Zu lang: Höchstens 248 Bytes.');
    expect(inputsOf(page)).toEqual([]);
    expect(mounted.get<HTMLInputElement>('input').element.value).toBe(long);
  });

  it('waits for a run', async () => {
    const page = createPage();
    const mounted = mountOn(page, RadioPanel);
    expect((named('Nachricht funken') as HTMLButtonElement).disabled).toBe(true);
    await mounted.get('input').setValue('hallo');
    await mounted.get('form').trigger('submit');
    expect(page.radio.entries.value).toEqual([]);
    expect(mounted.get<HTMLInputElement>('input').element.value).toBe('hallo');
  });

  it('looks back with the rest: what was sent later than the moment that is looked at stands below a line', async () => {
    const { page, mounted, send, entries } = await panel({ ...on, timeUs: 3_000_000 });
    const radio = [packet('early', 1_000_000), packet('late', 2_000_000)];
    page.say({ type: 'events', events: { sound: [], radio, radioDropped: 0, log: [] }, device: 0 });
    page.run.look.back();
    page.run.look.at(1_500_000, { ...page.run.present.value!, timeUs: 1_500_000 });
    await settle();
    expect(entries().map((it) => it.replace(/^.*(early|late|später).*$/, '$1'))).toEqual(['early', 'später', 'late']);
    expect(mounted.findAll('.later').map((it) => textOf(it.element))).toEqual([expect.stringContaining('late')]);
    const before = inputsOf(page).length;
    await send('now');
    expect([inputsOf(page).length, page.radio.entries.value.length]).toEqual([before, 2]);
    await vi.dynamicImportSettled(); // why not is told
    page.run.look.leave();
    await settle();
    expect(entries()).toHaveLength(2);
  });
});
