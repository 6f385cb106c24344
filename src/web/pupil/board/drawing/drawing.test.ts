// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import LedMatrix from './LedMatrix.vue';
import MicrophoneSign from './MicrophoneSign.vue';
import MotorWheel from './MotorWheel.vue';
import PowerSign from './PowerSign.vue';
import PressKey from './PressKey.vue';
import RgbLight from './RgbLight.vue';
import SoundSign from './SoundSign.vue';

const dark = Array.from({ length: 25 }, () => 0);
const only = (place: number, level: number) => dark.map((_, at) => (at === place ? level : 0));

describe('the 5 × 5 lights of a drawing', () => {
  const matrix = (levels: readonly number[], lit = true) =>
    mount(LedMatrix, { props: { levels, lit, label: 'Anzeige', dark: '#333' } });
  const opacities = (drawing: ReturnType<typeof matrix>) =>
    drawing.findAll('#LEDsOn > g').map((it) => Number(it.attributes('opacity')));

  it('glow the more, the higher their level', () => {
    const [none, low, high] = [0, 1, 9].map((level) => opacities(matrix(only(0, level)))[0]!);
    expect(none).toBe(0);
    expect(low).toBeGreaterThan(0);
    expect(high).toBeGreaterThan(low!);
    expect(high).toBeLessThanOrEqual(1);
  });

  it('are named column by column, as hosts know them: the second of the first row is the sixth', () => {
    const glowing = opacities(matrix(only(1, 9))).map((it) => it > 0);
    expect(glowing.indexOf(true)).toBe(5);
    expect(glowing.filter(Boolean)).toHaveLength(1);
  });

  it('are read row by row', () => {
    const said = matrix(only(1, 9)).attributes('aria-label');
    expect(said).toBe('Anzeige: 0 9 0 0 0, 0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0, 0 0 0 0 0');
  });

  it('are all dark without power, for the eye and for the ear', () => {
    const drawing = matrix(only(1, 9), false);
    expect(opacities(drawing).every((it) => it === 0)).toBe(true);
    expect(drawing.attributes('aria-label')).not.toContain('9');
    expect(drawing.get('#LEDsOn').attributes('visibility')).toBe('hidden');
  });

  it('are dark where a level is missing', () => {
    expect(opacities(matrix([9]))).toHaveLength(25);
    expect(opacities(matrix([9])).filter((it) => it > 0)).toHaveLength(1);
  });
});

describe('a light that says something', () => {
  it.each([
    ['the microphone', MicrophoneSign, 'on'],
    ['the loudspeaker', SoundSign, 'sounding'],
  ] as const)('%s speaks to screen readers only while it is on', async (_name, Sign, prop) => {
    const sign = mount(Sign, { props: { [prop]: false, label: 'hört zu' } as never });
    expect(sign.attributes()).toMatchObject({ 'aria-hidden': 'true' });
    expect(sign.attributes('role')).toBeUndefined();
    await sign.setProps({ [prop]: true });
    expect(sign.attributes()).toMatchObject({ role: 'img', 'aria-label': 'hört zu' });
    expect(sign.attributes('aria-hidden')).toBeUndefined();
  });

  it('the sign of a board that sleeps differs from that of one that is off; one that is on has none', () => {
    const sign = (power: 'on' | 'asleep' | 'off') => mount(PowerSign, { props: { power } });
    expect(sign('on').find('path').exists()).toBe(false);
    expect(sign('asleep').get('path').attributes('d')).not.toBe(sign('off').get('path').attributes('d'));
  });

  it('a coloured light keeps its hue when it is dim, and glows less', () => {
    const light = (red: number) => mount(RgbLight, { props: { red, green: 0, blue: 0 } });
    const glow = (red: number) => Number(light(red).get('circle').attributes('opacity'));
    expect(light(20).attributes('style')).toBe(light(255).attributes('style'));
    expect(glow(0)).toBe(0);
    expect(glow(20)).toBeGreaterThan(0);
    expect(glow(20)).toBeLessThan(glow(255));
  });
});

describe('the wheel on a motor output', () => {
  const wheel = (duty: number, side: 'start' | 'end' = 'start') =>
    mount(MotorWheel, { props: { duty, moving: false, side } });

  it.each([
    [0.6, 'forwards', '60 %'],
    [-0.25, 'backwards', '−25 %'],
    [0, 'still', '0 %'],
    [7, 'forwards', '100 %'],
  ])('of duty %s goes %s and says %s', (duty, direction, percent) => {
    const drawing = wheel(duty);
    expect(drawing.classes()).toContain(direction);
    expect(drawing.get('text').text()).toBe(percent);
  });

  it('has an arrow the right side round, and none while it stands still', () => {
    expect(wheel(0).find('.arrow').exists()).toBe(false);
    expect(wheel(1).get('.arrow').attributes('transform')).toBeUndefined();
    expect(wheel(-1).get('.arrow').attributes('transform')).toBe('scale(-1 1)');
  });

  it('writes its number into the drawing, not beyond its edge', () => {
    expect(wheel(1, 'start').get('text').attributes('x')).toBe('-18');
    expect(wheel(1, 'end').get('text').attributes('x')).toBe('18');
  });

  it('turns at one and a half turns a second at full duty, backwards too, and stops with the run', async () => {
    const rates: number[] = [];
    let isPaused = true;
    const turning = {
      currentTime: 0,
      updatePlaybackRate: (rate: number) => rates.push(rate),
      play: () => (isPaused = false),
      pause: () => (isPaused = true),
      cancel: () => undefined,
    };
    const animate = Object.getOwnPropertyDescriptor(Element.prototype, 'animate');
    Element.prototype.animate = () => turning as never;
    const drawing = mount(MotorWheel, { props: { duty: 1, moving: true, side: 'start' } });
    expect([rates.at(-1), isPaused]).toEqual([1.5, false]);
    await drawing.setProps({ duty: -0.5 });
    expect([rates.at(-1), isPaused]).toEqual([-0.75, false]);
    await drawing.setProps({ moving: false });
    await nextTick();
    expect(isPaused).toBe(true);
    drawing.unmount();
    if (animate === undefined) Reflect.deleteProperty(Element.prototype, 'animate');
    else Object.defineProperty(Element.prototype, 'animate', animate);
  });
});

describe('something to press in a drawing', () => {
  it('is a button for the keyboard and for screen readers, with its state', async () => {
    const pressed: string[] = [];
    const handlers = { pointerdown: () => pressed.push('down'), pointerup: () => pressed.push('up') };
    const key = mount(PressKey, { props: { label: 'Taste A', down: false, handlers: handlers as never } });
    expect(key.attributes()).toMatchObject({
      role: 'button',
      tabindex: '0',
      'aria-label': 'Taste A',
      'aria-pressed': 'false',
    });
    await key.trigger('pointerdown');
    await key.trigger('pointerup');
    expect(pressed).toEqual(['down', 'up']);
    await key.setProps({ down: true });
    expect(key.attributes('aria-pressed')).toBe('true');
    expect(key.classes()).toContain('down');
  });
});
