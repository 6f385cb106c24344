import { describe, expect, it } from 'vitest';
import type { Bench } from '#board/testing/bench';
import { linesOf, play } from './testing/play';

const encode = (text: string): Uint8Array => Uint8Array.of(1, 0, 1, ...new TextEncoder().encode(text));

/** Packets arrive at these ms after the start. */
function arriving(packets: readonly (readonly [ms: number, bytes: Uint8Array])[]) {
  return ({ clock, board }: Bench): void => {
    for (const [ms, bytes] of packets) clock.at(ms * 1000, () => board.radio.receive(bytes));
  };
}

describe('radio', () => {
  it('is switched on by its import, and by nothing else', () => {
    expect(play('import microbit').until(10).bench.board.radio.isOn).toBe(false);
    expect(play('import radio').until(10).bench.board.radio.isOn).toBe(true);
    expect(play('import microbit, radio as r\nr.off()').until(10).bench.board.radio.isOn).toBe(false);
    expect(play('import radio', { 'radio.py': 'x = 1' }).until(10).bench.board.radio.isOn).toBe(false);
  });

  it('sends text behind 1, 0, 1 and bytes as they are, a packet in 700 µs', () => {
    const sent: string[] = [];
    const setUp = ({ board, clock }: Bench): void =>
      void board.radio.onSend((bytes) => sent.push(`${Math.floor(clock.nowUs / 100)} ${[...bytes].join(' ')}`));
    const program = `
import radio
radio.send('hü')
radio.send_bytes(b'\\x00\\xff')
radio.send_bytes(bytearray([7]))
radio.send_bytes('x' * 40)`;
    play(program, {}, setUp).until(20);
    expect(sent.map((line) => line.slice(line.indexOf(' ') + 1))).toEqual([
      '1 0 1 104 195 188',
      '0 255',
      '7',
      Array.from({ length: 32 }, () => '120').join(' '),
    ]);
    const times = sent.map((line) => Number(line.split(' ')[0]));
    expect((times[1] ?? 0) - (times[0] ?? 0)).toBe(7);
  });

  it('receives text, bytes, and all that is known of a packet', () => {
    const program = `
import radio
print(radio.receive(), radio.receive_bytes(), radio.receive_full())
sleep(100)
print(radio.receive(), radio.receive_bytes())
message, rssi, t = radio.receive_full()
print(message, rssi, t)
buf = bytearray(4)
print(radio.receive_bytes_into(buf), buf, radio.receive_bytes_into(buf))`;
    const setUp = arriving([
      [10, encode('Grüezi')],
      [20, Uint8Array.of(1, 2, 3)],
      [30.5, encode('ok')],
      [40, Uint8Array.of(9, 8, 7, 6, 5, 4)],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual([
      'None None None',
      "Grüezi b'\\x01\\x02\\x03'",
      "b'\\x01\\x00\\x01ok' -50 30500",
      "6 bytearray(b'\\t\\x08\\x07\\x06') None",
    ]);
  });

  it('receives a text that was cut inside a sign, as long as it came: nobody checks it', () => {
    const program = `
import radio
sleep(50)
for _ in range(3):
    m = radio.receive()
    print(len(m), m[:2], m == m + '', len(m.encode()))
    display.scroll(m, 10)
radio.send(m)`;
    const cut = (text: string, bytes: number): Uint8Array => encode(text).slice(0, 3 + bytes);
    const sent: number[][] = [];
    const setUp = (bench: Bench): void => {
      bench.board.radio.onSend((bytes) => void sent.push([...bytes]));
      arriving([
        [10, cut('übcü', 5)],
        [20, cut('ab€', 3)],
        [30, cut('ab€', 4)],
      ])(bench);
    };
    expect(linesOf(program, {}, setUp)).toEqual(['4 üb True 5', '3 ab True 3', '3 ab True 4']);
    expect(sent).toEqual([[1, 0, 1, 97, 98, 0xe2, 0x82]]);
  });

  it('says that a packet is no text, and goes on with the next', () => {
    const program = `
import radio
sleep(50)
err(radio.receive)
print(radio.receive())`;
    const setUp = arriving([
      [10, Uint8Array.of(1, 2, 3)],
      [20, encode('next')],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual(['ValueError: received packet is not a string', 'next']);
  });

  it('keeps three messages of full length', () => {
    const program = `
import radio
sleep(50)
print([radio.receive()[0] for i in range(3)], radio.receive())
radio.config(queue=5)
sleep(50)
print([radio.receive()[0] for i in range(5)], radio.receive())`;
    const five = (ms: number) => Array.from('abcde').map((letter, i) => [ms + i, encode(letter.repeat(29))] as const);
    expect(linesOf(program, {}, arriving([...five(10), ...five(60)]))).toEqual([
      "['a', 'b', 'c'] None",
      "['a', 'b', 'c', 'd', 'e'] None",
    ]);
  });

  it('refuses what cannot be set, and then sets nothing', () => {
    const program = `
import radio
err(radio.config, 5)
for args in ({'length': 252}, {'queue': 0}, {'channel': 84}, {'power': 8}, {'group': 256}, {'data_rate': 3}, {'speed': 1}):
    err(radio.config, **args)
err(radio.config, group='a')
err(radio.config, group=7, channel=99)
radio.config(group=23, channel=83, power=0, length=251, queue=2, address=0xdeadbeef, data_rate=radio.RATE_2MBIT)
print(radio.RATE_1MBIT, radio.RATE_2MBIT)`;
    const names = ['length', 'queue', 'channel', 'power', 'group', 'data_rate'];
    let board: Bench['board'] | undefined;
    const lines = linesOf(program, {}, (bench) => (board = bench.board));
    expect(lines).toEqual([
      'TypeError: arguments must be keywords',
      ...names.map((name) => `ValueError: value out of range for argument '${name}'`),
      "ValueError: unknown argument 'speed'",
      "TypeError: can't convert str to int",
      "ValueError: value out of range for argument 'channel'",
      '0 1',
    ]);
    expect(board?.radio.config).toEqual({
      length: 251,
      queue: 2,
      channel: 83,
      power: 0,
      address: 0xdeadbeef,
      group: 23,
      dataRate: 1,
    });
  });

  it('says when it is off, and refuses what it cannot send', () => {
    const program = `
import radio
err(radio.send, 5)
err(radio.send_bytes, 5)
err(radio.receive_bytes_into, b'abc')
radio.off()
for call in (radio.receive, radio.receive_bytes, radio.receive_full):
    err(call)
err(radio.send, 'hi')
err(radio.send_bytes, b'hi')
err(radio.receive_bytes_into, bytearray(3))
radio.on()
print(radio.receive())`;
    expect(linesOf(program)).toEqual([
      "TypeError: can't convert 'int' object to str implicitly",
      'TypeError: object with buffer protocol required',
      'TypeError: object with buffer protocol required',
      ...Array.from({ length: 6 }, () => 'ValueError: radio is not enabled'),
      'None',
    ]);
  });

  it('takes its queue from the heap, as on the device', () => {
    const program = `
import radio
err(radio.config, length=251, queue=254)
err(radio.receive)`;
    expect(linesOf(program)).toEqual([
      'MemoryError: memory allocation failed, allocating 65535 bytes',
      'ValueError: radio is not enabled',
    ]);
  });

  it('is off and as at first after a reset', () => {
    const run = play(`
import os, microbit
if 'seen' not in os.listdir():
    open('seen', 'w').close()
    import radio
    radio.config(group=9)
    microbit.reset()
print('again')`);
    expect(run.until(3000).printed()).toBe('again\n');
    expect([run.bench.board.radio.isOn, run.bench.board.radio.group]).toEqual([false, 0]);
  });
});
