import { describe, expect, it } from 'vitest';
import { fetchDrawing, fetchedDrawing } from './drawings';
import { robotTypes } from './index';

describe('the drawing of a robot', () => {
  it('shows what comes in the box, and what is plugged in or taken off by an option', async () => {
    const parts = async (options?: Record<string, string>): Promise<string[]> => {
      const drawing = await fetchDrawing('maqueen-plus-v3', options);
      return ['ultrasonic', 'lidar'].filter((part) => drawing.includes(`id="${part}"`));
    };
    expect(await parts()).toEqual(['lidar']);
    expect(await parts({ ultrasonic: 'yes', lidar: '8x8' })).toEqual(['ultrasonic', 'lidar']);
    expect(await parts({ ultrasonic: 'no', lidar: 'none' })).toEqual([]);
    expect(fetchedDrawing('maqueen-plus-v3', { ultrasonic: 'yes', lidar: 'none' })).toContain('id="ultrasonic"');
  });

  it('names choices of its robot where it has optional parts, and stays well formed without them', async () => {
    for (const { id, options } of robotTypes) {
      const choices = options.flatMap((option) => option.choices.map((choice) => `${option.id}=${choice.id}`));
      const all = Object.fromEntries(options.map((option) => [option.id, option.choices.at(-1)?.id ?? '']));
      const [boxed, plugged] = [await fetchDrawing(id), await fetchDrawing(id, all)];
      for (const [, named = ''] of (boxed + plugged).matchAll(/data-(?:if|unless)="([^"]*)"/g))
        expect(choices, id).toContain(named);
      for (const drawing of [boxed, plugged])
        expect(drawing.match(/<g[ >]/g)?.length, id).toBe(drawing.match(/<\/g>/g)?.length);
    }
  });
});
