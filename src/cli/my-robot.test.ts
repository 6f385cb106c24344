import { describe, expect, it } from 'vitest';
import { projectToText } from '#project/file';
import { measuredProject } from '#project/testing/projects';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { file } = useFolder();

describe('parcours run with a measured robot', { timeout: 60_000 }, () => {
  const project = measuredProject();
  const measured = file('class.json', projectToText(project));
  const forward = file(
    'forward.py',
    'from mbrobot_plusV2 import *\nprint(irL1.read_analog(), irM.read_analog())\nforward()\ndelay(2000)\nstop()\n',
  );
  const turnedDeg = (...more: readonly string[]): number => {
    return lastLine(parcours('run', forward, '--json', ...more).out).robot?.turnedDeg ?? NaN;
  };

  it('drives as that one does: it drifts to the right, the robot of the type does not', () => {
    expect(turnedDeg()).toBeCloseTo(0, 6);
    expect(turnedDeg('--my-robot', measured)).toBeLessThan(-5);
  });

  it('reads its line sensors as that one does', () => {
    expect(parcours('run', forward, '--my-robot', measured).out).toContain('212 230');
    expect(parcours('run', forward).out).toContain('230 230');
  });

  it('is refused for another robot, with the way out', () => {
    const { err, code } = parcours('run', forward, '--robot', 'callibot', '--my-robot', measured);
    expect(err).toBe('parcours: --my-robot: "Roboter 3" is a maqueen-plus-v2, but here drives a callibot. Choose --robot maqueen-plus-v2.\n'); // prettier-ignore
    expect(code).toBe(2);
  });

  it('says so when the file has none, or is none', () => {
    const without = file('plain.json', projectToText({ files: project.files, scene: project.scene, course: null }));
    expect(parcours('run', forward, '--my-robot', without).err).toContain(
      'plain.json: this project has no measured robot.',
    );
    expect(parcours('run', forward, '--my-robot', forward).err).toContain('forward.py: The project file is not JSON');
    expect(parcours('run', forward, '--my-robot', 'nowhere.json').code).toBe(2);
  });
});
