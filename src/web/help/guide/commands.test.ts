import { describe, expect, it } from 'vitest';

import type { ReferenceContext } from '#reference/context';
import { loadReferenceTexts, textsOfRobot } from '#reference/texts';
import { robotReferences } from '#robots/references';
import { commandsOf } from './commands';

const context: ReferenceContext = {
  board: 'microbit-v2',
  features: [],
  files: {},
  modules: robotReferences.flatMap(({ modules }) => modules),
};
const named = (module: string, name: string) => commandsOf(module, context).find((command) => command.name === name);

describe('the commands in the help', () => {
  it('are the functions of a robot and those of its parts', () => {
    expect(named('mbrobot', 'forward')).toMatchObject({ code: 'forward()', text: 'mbrobot.forward' });
    expect(named('mbrobot', 'irLeft.read_digital')?.code).toBe('irLeft.read_digital()');
    expect(named('microbit', 'display.show')?.code).toBe('display.show(image)');
  });

  it('are written with the arguments that must be given', () => {
    expect(named('mbrobot', 'leftArc')?.code).toBe('leftArc(radius)');
    expect(named('mbrobot', 'setLED')?.code).toBe('setLED(state)');
    expect(named('microbit', 'display.set_pixel')?.code).toBe('display.set_pixel(x, y, value)');
    expect(named('microbit', 'display.scroll')?.calls[0]).toContain('delay: int = 150');
    expect(named('microbit', 'display.scroll')?.calls[0]).not.toContain('->');
  });

  it('stand there once, though both buttons and all pins have the same', () => {
    const commands = commandsOf('microbit', context);
    expect(commands.filter(({ name }) => name.endsWith('.is_pressed')).map(({ name }) => name)).toEqual([
      'button_a.is_pressed',
    ]);
    expect(new Set(commands.map(({ text }) => text)).size).toBe(commands.length);
  });

  it('leave out what the device does not have', () => {
    expect(named('mbrobot', 'irLeft.read_analog')).toBeUndefined();
    expect(named('microbit', 'display.rotate')).toBeUndefined();
  });

  it('have words in the reference, for every robot and for the board', async () => {
    for (const reference of robotReferences) {
      const texts = textsOfRobot(reference, 'de');
      for (const { name } of reference.modules)
        for (const { text } of commandsOf(name, context).filter(({ text }) => text.startsWith(name)))
          expect(texts[text] ?? '', text).not.toBe('');
    }
    const words = await loadReferenceTexts('de');
    for (const { text } of commandsOf('microbit', context)) expect(words[text] ?? '', text).not.toBe('');
  });

  it('are none where there is no such module', () => {
    expect(commandsOf('nothing', context)).toEqual([]);
  });
});
