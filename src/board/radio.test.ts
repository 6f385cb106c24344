import { describe, expect, it } from 'vitest';
import type { Radio } from './radio';
import { createBench } from './testing/bench';

const packet = (length: number, first = 0): Uint8Array => Uint8Array.from({ length }, (_, i) => first + i);

function radioOn(): Radio {
  const { radio } = createBench().board;
  radio.on();
  return radio;
}

describe('radio', () => {
  it('N1: is off at the start, and hears and sends nothing', () => {
    const { radio } = createBench().board;
    const sent: Uint8Array[] = [];
    radio.onSend((bytes) => sent.push(bytes));
    radio.receive(packet(3));
    radio.send(packet(3));
    expect([radio.isOn, sent, radio.oldest]).toEqual([false, [], null]);
    radio.on();
    radio.send(packet(3));
    expect([radio.isOn, radio.group, radio.channel, sent]).toEqual([true, 0, 7, [packet(3)]]);
  });

  it('N2: what is too long is cut, sent or received: to 32 bytes at first', () => {
    const radio = radioOn();
    const sent: number[] = [];
    radio.onSend((bytes) => sent.push(bytes.length));
    radio.send(packet(40));
    radio.receive(packet(40));
    radio.configure({ length: 251 });
    radio.send(packet(251));
    radio.receive(packet(255));
    expect([sent, radio.take()?.bytes.length]).toEqual([[32, 251], 251]);
  });

  it('N3: keeps three messages of 32 bytes; more are lost until one is taken', () => {
    const radio = radioOn();
    for (let i = 0; i < 5; i++) radio.receive(packet(32, i));
    const taken = [radio.take(), radio.take(), radio.take(), radio.take()];
    expect(taken.map((message) => message?.bytes[0])).toEqual([0, 1, 2, undefined]);
    radio.receive(packet(32, 9));
    expect(radio.take()?.bytes[0]).toBe(9);
  });

  it('N3: short messages take less room: of 6 bytes nine', () => {
    const radio = radioOn();
    for (let i = 0; i < 12; i++) radio.receive(packet(6));
    let count = 0;
    while (radio.take()) count++;
    expect(count).toBe(9);
  });

  it('N4: a message has arrived with −50 dBm at its time', () => {
    const { board, passMs } = createBench();
    board.radio.on();
    passMs(12.345);
    board.radio.receive(packet(1));
    expect(board.radio.oldest).toEqual({ bytes: packet(1), rssiDbm: -50, timeUs: 12_345 });
  });

  it('N5: another length or queue empties the queue, another group does not', () => {
    const radio = radioOn();
    radio.receive(packet(1));
    radio.configure({ group: 23, channel: 40 });
    expect([radio.group, radio.channel, radio.oldest?.bytes.length]).toEqual([23, 40, 1]);
    radio.configure({ queue: 4 });
    expect(radio.oldest).toBeNull();
  });

  it('N6: settings are forgotten by the next on or configure, not before', () => {
    const radio = radioOn();
    radio.configure({ group: 23 });
    radio.forget();
    expect(radio.group).toBe(23);
    radio.on();
    expect(radio.group).toBe(0);
  });

  it('N7: off loses what waits; a reset also forgets the settings, and who listens outside still hears', () => {
    const radio = radioOn();
    const sent: number[] = [];
    const stop = radio.onSend((bytes) => sent.push(bytes.length));
    radio.configure({ group: 5 });
    radio.receive(packet(2));
    radio.reset();
    expect([radio.isOn, radio.group, radio.oldest]).toEqual([false, 0, null]);
    radio.on();
    radio.send(packet(2));
    stop();
    radio.send(packet(3));
    expect(sent).toEqual([2]);
  });
});
