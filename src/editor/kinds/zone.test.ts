import { describe, expect, it } from 'vitest';
import { defaultScene, type Zone } from '#scene/scene';
import { usualToolOptions } from '../tools/tool-options';
import { target } from './zone';

const made = (zoneBlocks: number, zoneBlockColor: 'red' | null): Zone | null =>
  target.made('t', [300, 300], defaultScene(), { ...usualToolOptions, zoneBlocks, zoneBlockColor });

const fieldOf = (zone: Zone, name: string) => target.fields(zone).find((field) => field.name === name);

describe('a target', () => {
  it('wants blocks of the colour that is chosen beside the tool, or of any', () => {
    expect(made(2, 'red')).toMatchObject({ blocks: 2, blockColor: 'red' });
    expect(made(2, null)).not.toHaveProperty('blockColor');
    expect(made(0, 'red')).not.toHaveProperty('blockColor');
  });

  it('has a field for their colour while it wants any', () => {
    const zone = made(2, null)!;
    expect(fieldOf(made(0, null)!, 'blockColor')).toBeUndefined();
    const red = fieldOf(zone, 'blockColor')?.with('red', defaultScene()) as Zone;
    expect(red).toEqual({ ...zone, blockColor: 'red' });
    expect(fieldOf(red, 'blockColor')).toMatchObject({ value: 'red' });
    expect(fieldOf(red, 'blockColor')?.with('any', defaultScene())).toEqual(zone);
    expect(fieldOf(red, 'blocks')?.with(3, defaultScene())).toMatchObject({ blocks: 3, blockColor: 'red' });
    expect(fieldOf(red, 'blocks')?.with(0, defaultScene())).not.toHaveProperty('blockColor');
  });
});
