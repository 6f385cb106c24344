import { describe, expect, it } from 'vitest';

import {
  addedDevice,
  deviceNameProblem,
  deviceNames,
  filesOfDevice,
  freeDeviceName,
  removedDevice,
  renamedDevice,
  withFiles,
} from './devices';
import { anyHardware } from './project';
import { devicesProject, fullProject } from './testing/projects';

const mainOf = (place: number, project = devicesProject()) => filesOfDevice(project, place)[0]?.text;

describe('the devices of a project', () => {
  it('are one, until a second is added', () => {
    const alone = fullProject();
    expect(deviceNames(alone)).toEqual(['1']);
    const device = { ...anyHardware, name: 'B', files: [], sameAs: 'A' };
    const pair = addedDevice(alone, device, 'A');
    expect([deviceNames(pair), filesOfDevice(pair, 1)]).toEqual([['A', 'B'], alone.files]);
    expect(removedDevice(pair, 1)).toEqual(alone);
  });

  it('may run the program of another one: what is written in one is then in both', () => {
    expect(mainOf(2)).toBe(mainOf(1));
    const written = withFiles(devicesProject(), 2, [{ name: 'main.py', text: 'new' }]);
    expect([0, 1, 2].map((place) => mainOf(place, written))).toEqual([mainOf(0), 'new', 'new']);
  });

  it('keep the program that they shared when its device goes', () => {
    const left = removedDevice(devicesProject(), 1);
    expect([deviceNames(left), mainOf(1, left)]).toEqual([['Roboter', 'Ärzt 2'], mainOf(1)]);
  });

  it('still run the same program when its device gets another name', () => {
    const renamed = renamedDevice(devicesProject(), 1, 'Sender');
    expect([deviceNames(renamed), mainOf(2, renamed)]).toEqual([['Roboter', 'Sender', 'Ärzt 2'], mainOf(1)]);
    expect(deviceNames(renamedDevice(renamed, 0, 'Robi'))).toEqual(['Robi', 'Sender', 'Ärzt 2']);
  });

  it('have names of their own that can stand before a line', () => {
    const names = ['Robot', 'Hand'];
    expect(deviceNameProblem('Hand', names)).toBe('nameTaken');
    expect(deviceNameProblem('Hand', names, 'Hand')).toBeNull();
    for (const name of ['a=b', 'a,b', 'a\nb', ' a', 'a '])
      expect(deviceNameProblem(name, names)).toBe('nameCharacters');
    expect([deviceNameProblem('', names), deviceNameProblem('x'.repeat(31), names)]).toEqual(['nameEmpty', 'nameLong']);
    expect([freeDeviceName('Robot', names), freeDeviceName('Robot', ['Robot', 'Robot 2'])]).toEqual([
      'Robot 2',
      'Robot 3',
    ]);
  });
});
