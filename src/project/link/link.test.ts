import { readFileSync } from 'node:fs';

import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { defaultScene, sceneDefaults, type Block, type Scene, type SceneObject } from '#scene/scene';

import { ColumnWriter, type Bytes } from './columns';
import { BACKGROUND_LINK_CHARACTERS, isProjectLink, linkOf, linkOfBytes, projectOfLink, type ReadLink } from './link';
import { deflatedBytes } from './link-bytes';
import { deflatedContent, laterVersions, modelledContent } from './link-content';
import { MODELLED_BYTES, ModelWriter } from './model-coder';
import { defaultProjectSettings, type Project } from '../project';
import { drawings, drawn, wildDrawings } from '../testing/drawings';
import {
  classProject,
  devicesProject,
  handedInProject,
  coloursProject,
  heightsProject,
  shapesProject,
  startsProject,
  FORTY_LINES,
  fortyObjects,
  fullProject,
  largeProject,
  measuredProject,
  taskProject,
} from '../testing/projects';

const none = (): null => null;
const ready: Scene = { ...defaultScene(), name: 'Fertig', objects: [{ type: 'wall', id: 'w', from: [0, 0], to: [9, 9], thickness: 10 }] }; // prettier-ignore
const courses = (id: string): Scene | null => (id === 'ready' ? ready : null);
const small: Project = { files: [{ name: 'main.py', text: FORTY_LINES }], scene: ready, course: 'ready' };

const link = (project: Project, program = true): string => linkOf(project, { courses, program })?.fragment ?? '';
const codeOf = (read: ReadLink): string | null => ('problem' in read ? read.problem.code : null);
const projectIn = (fragment: string): Project | null => {
  const read = projectOfLink(fragment, courses);
  return 'project' in read ? read.project : null;
};

function withDrawing(of: (typeof drawings)[string], seed: number): Project {
  const project = largeProject(seed);
  return { ...project, scene: { ...project.scene, objects: [...drawn(of, seed), ...fortyObjects(seed)] } };
}

describe('a link', () => {
  it('opens the same project: every type of object, all options, all files', () => {
    const largest = { ...fullProject().scene.robot, at: [-20_000, 20_000] as const, heading: -359.999_999 };
    for (const project of [
      small,
      fullProject(),
      taskProject(),
      { ...fullProject(), scene: { ...fullProject().scene, robot: largest, background: null } },
      { ...small, course: 'gone' },
      { ...small, course: null, scene: { ...ready, objects: [] } },
    ]) {
      expect(projectIn(link(project))).toEqual(project);
    }
  });

  it('has only characters that collectors of links accept', () => {
    expect(link(taskProject())).toMatch(/^p=3\.[A-Za-z0-9_-]+$/);
    expect(link(fullProject())).toMatch(/^p=2\.[A-Za-z0-9_-]+$/);
    expect(isProjectLink(`#${link(small)}`)).toBe(true);
    expect(isProjectLink('#robots')).toBe(false);
  });

  it('stays within 2.7 kB for 5,000 pen points, 40 objects and a program of 40 lines, whatever a hand draws', () => {
    for (const [name, of] of Object.entries(drawings))
      for (const seed of [1, 2, 3]) {
        const project = withDrawing(of, seed);
        const made = link(project);
        expect(made.length, `${name} ${String(seed)}`).toBeLessThan(2_700);
        expect(projectIn(made)).toEqual(project);
      }
  });

  it('is not much longer for a drawing that nobody draws on purpose', () => {
    for (const of of Object.values(wildDrawings)) {
      const project = withDrawing(of, 1);
      expect(link(project).length).toBeLessThan(5_500);
      expect(projectIn(link(project))).toEqual(project);
    }
  });

  it('names a ready course that was not changed, and holds one that was', () => {
    const bare = { ...small, files: [{ name: 'main.py', text: 'x' }] };
    expect(link(bare).length).toBeLessThan(60);
    const moved: Scene = { ...ready, robot: { ...ready.robot, at: [100, 100] } };
    expect(projectIn(link({ ...small, scene: moved }))?.scene).toEqual(moved);
  });

  it('opens today’s version of a ready course that was mended meanwhile, and says so', () => {
    const before = linkOf({ ...small, scene: { ...ready, objects: [] } }, { courses: () => ({ ...ready, objects: [] }), program: true }); // prettier-ignore
    expect(projectOfLink(before?.fragment ?? '', courses)).toEqual({ project: small, isCourseChanged: true });
    expect(projectOfLink(link(small), courses)).toMatchObject({ isCourseChanged: false });
    expect(codeOf(projectOfLink(link(small), none))).toBe('unknown-course');
  });

  it('opens with an empty program if it has none', () => {
    expect(projectIn(link(fullProject(), false))).toEqual({ ...fullProject(), files: [{ name: 'main.py', text: '' }] });
  });
});

describe('the background in a link', () => {
  const withBackground = (levels: string, picture: string): Project => {
    const scene = {
      ...ready,
      background: { at: [0, 0], size: [400, 300], cells: [400, 300], levels, picture } as const,
    };
    return { ...small, scene, course: null };
  };
  const random = (bytes: number): Uint8Array => {
    const rng = createRng(5);
    return Uint8Array.from({ length: bytes }, () => rng.u32() & 255);
  };
  const noise = (bytes: number): string => Buffer.from(random(bytes)).toString('base64');
  const levels = noise(600);
  const picture = `data:image/jpeg;base64,${noise(60_000)}`;
  const made = (project: Project) => linkOf(project, { courses, program: true });

  it('comes along as long as the link has at most 8,000 characters', () => {
    const project = withBackground(levels, 'data:image/png;base64,iVBORw0KGgo=');
    expect(made(project)?.omitted).toEqual([]);
    expect(projectIn(link(project))).toEqual(project);
  });

  it('goes without its picture, which no sensor sees, where that is too large', () => {
    const read = made(withBackground(levels, picture));
    expect(read?.omitted).toEqual(['picture']);
    expect(projectIn(read?.fragment ?? '')?.scene.background).toMatchObject({ levels, picture: '' });
  });

  it('stays behind where it is too large by itself', () => {
    const read = made(withBackground(noise(30_000), picture));
    expect(read?.omitted).toEqual(['background']);
    expect(read?.fragment.length).toBeLessThan(BACKGROUND_LINK_CHARACTERS);
    expect(projectIn(read?.fragment ?? '')?.scene.background).toBeNull();
  });
});

describe('a link that is not whole', () => {
  const whole = link(fullProject());

  it('is damaged when a part is missing or another character stands in it', () => {
    const { length } = whole;
    for (const text of [
      '',
      '#',
      'p=',
      '#p=1.',
      '#p=1.AA',
      '#p=2.AA',
      whole.slice(0, -1),
      whole.slice(0, length / 2),
      `${whole}AA`,
    ])
      expect(codeOf(projectOfLink(text, courses))).toBe('damaged');
    for (let at = 4; at < length; at += 7) {
      const other = whole.charAt(at) === 'A' ? 'B' : 'A';
      expect(codeOf(projectOfLink(whole.slice(0, at) + other + whole.slice(at + 1), courses))).toBe('damaged');
    }
    for (const sign of ['+', '/', '%', ' ', 'ü'])
      expect(codeOf(projectOfLink(`${whole}${sign}A`, courses))).toBe('damaged');
  });

  it('may have lost nothing but its # or gained padding', () => {
    expect(projectIn(`#${whole}`)).toEqual(fullProject());
    expect(projectIn(`${whole}=`)).toEqual(fullProject());
    expect(projectIn(` ${whole}\n`)).toEqual(fullProject());
  });

  it('asks to reload the page if it is of a newer version', () => {
    const read = projectOfLink('#p=12.abc', courses);
    expect('problem' in read && read.problem.message).toBe('The link is of version 12; this app reads version 11. Reload the page to update.'); // prettier-ignore
    expect(codeOf(projectOfLink('#p=0.abc', courses))).toBe('damaged');
  });
});

describe('a hostile link', () => {
  it('is given up as soon as it unpacks to more than 4 MB', () => {
    const bomb = (figures: Uint8Array, words: Uint8Array): string => deflatedLink({ figures, words });
    const huge = new Uint8Array(40_000_000);
    expect(bomb(huge, new Uint8Array()).length).toBeLessThan(60_000);
    expect(codeOf(projectOfLink(bomb(huge, new Uint8Array()), courses))).toBe('too-large');
    expect(codeOf(projectOfLink(bomb(Uint8Array.of(0), huge), courses))).toBe('too-large');
    const half = new Uint8Array(2_500_000);
    expect(codeOf(projectOfLink(bomb(half, half), courses))).toBe('too-large');
  });

  it('is given up as soon as a model has read 64 kB of it', () => {
    const endless = new ModelWriter();
    const points = Array.from({ length: 33_000 }, (_, index) => [index % 2, 0] as const);
    const objects = [{ type: 'stroke', id: 's', points, width: 20, color: 'black' }] as const;
    const scene = { whole: { ...ready, objects } };
    modelledContent.codec.write(endless, { files: [], course: null, settings: null, scene, extras: {}, myRobot: '', devices: null, starts: [], sharing: null, additions: [], firstRobot: null, carried: '', heights: [], news: '' }); // prettier-ignore
    const read = projectOfLink(linkOfBytes({ version: 2, bytes: endless.bytes() }), courses);
    expect('problem' in read && read.problem).toMatchObject({ code: 'too-large', params: { max: MODELLED_BYTES } });
  });

  it('is not read when it is too long', () => {
    expect(codeOf(projectOfLink(`#p=1.${'A'.repeat(500_000)}`, courses))).toBe('too-long');
  });

  it('is damaged, without taking memory, if it counts more than it holds', () => {
    const out = new ColumnWriter();
    for (let column = 1; column < 60; column += 1) out.uint(column, 34_000_000_000);
    expect(codeOf(projectOfLink(deflatedLink(out.bytes()), courses))).toBe('damaged');
    const figures = Uint8Array.of(255, 255, 255, 255, 127);
    expect(codeOf(projectOfLink(deflatedLink({ figures, words: Uint8Array.of() }), courses))).toBe('damaged');
    const modelled = new ModelWriter();
    for (let column = 1; column < 60; column += 1) modelled.uint(column, 34_000_000_000);
    expect(codeOf(projectOfLink(linkOfBytes({ version: 2, bytes: modelled.bytes() }), courses))).toBe('damaged');
  });

  it('names the values that no file may have', () => {
    const scene = { ...ready, size: [10, 900] as const };
    const read = projectOfLink(link({ ...small, course: null, scene }), courses);
    expect(codeOf(read)).toBe('invalid');
    expect('problem' in read && read.problem.message).toContain('size[0]: 10 is not within 200 … 10000.');
  });
});

/** As version 1 made links. */
const deflatedLink = (bytes: Bytes): string => linkOfBytes({ version: 1, bytes: deflatedBytes(bytes) });

describe('a link of version 1', () => {
  const kept = keptLink(1);

  it('opens as it always did', () => {
    expect(projectIn(kept)).toEqual(fullProject());
  });

  it('is still made so: the order of columns and the likely words are the format', () => {
    const { files, course, scene, settings } = fullProject();
    const out = new ColumnWriter();
    deflatedContent.codec.write(out, {
      files,
      course,
      settings: settings ?? null,
      scene: { whole: scene },
      extras: {},
      myRobot: '',
      devices: null,
      starts: [],
      sharing: null,
      additions: [],
      firstRobot: null,
      carried: '',
      heights: [],
      news: '',
    });
    expect(deflatedLink(out.bytes())).toBe(kept);
  });

  it('is made for what is too large for a model', () => {
    const project = { ...small, files: [{ name: 'main.py', text: 'x = 1\n'.repeat(MODELLED_BYTES / 6) }] };
    expect(link(project)).toMatch(/^p=1\./);
    expect(projectIn(link(project))).toEqual(project);
  });
});

describe('a link of version 2', () => {
  const kept = keptLink(2);

  it('opens as it always did', () => {
    expect(projectIn(kept)).toEqual(fullProject());
  });

  it('is still made so: the order of columns, the likely words and all that the model learns by are the format', () => {
    expect(link(fullProject())).toBe(kept);
  });

  it('takes a tenth less than one of version 1 for a course without a drawing', () => {
    expect(kept.length).toBeLessThan(0.9 * keptLink(1).length);
  });
});

describe('a link of version 3', () => {
  const kept = keptLink(3);

  it('opens as it always did, with all that there is to read about the task', () => {
    expect(projectIn(kept)).toEqual(taskProject());
  });

  it('is still made so', () => {
    expect(link(taskProject())).toBe(kept);
  });

  it('is made only where an older app would lose something', () => {
    const { scene } = taskProject();
    const { seconds, noTouch } = scene.task;
    expect(link({ ...taskProject(), scene: { ...scene, task: { seconds, noTouch } } })).toMatch(/^p=2\./);
  });

  it('is made for what is too large for a model, too', () => {
    const project = { ...taskProject(), files: [{ name: 'main.py', text: 'x = 1\n'.repeat(MODELLED_BYTES / 6) }] };
    expect(link(project)).toMatch(/^p=3\./);
    expect(projectIn(link(project))).toEqual(project);
  });

  it('whose packing is unknown is damaged', () => {
    expect(codeOf(projectOfLink(linkOfBytes({ version: 3, bytes: Uint8Array.of(7, 1, 2) }), courses))).toBe('damaged');
  });

  it('names a course that has such a task itself', () => {
    const { scene } = taskProject();
    const made = linkOf({ ...taskProject(), course: 'own' }, { courses: () => scene, program: false });
    expect(made?.fragment).toMatch(/^p=2\./);
    expect(projectOfLink(made?.fragment ?? '', () => scene)).toMatchObject({
      project: { scene },
      isCourseChanged: false,
    });
  });
});

describe('a link of version 4', () => {
  const kept = keptLink(4);

  it('opens as it always did, with the pupil’s own robot', () => {
    expect(projectIn(kept)).toEqual(measuredProject());
  });

  it('is still made so', () => {
    expect(link(measuredProject())).toBe(kept);
  });

  it('is made only for a robot of one’s own', () => {
    expect(link({ ...measuredProject(), settings: defaultProjectSettings })).toMatch(/^p=2\./);
  });

  it('brings the task along, too', () => {
    const project = { ...taskProject(), settings: measuredProject().settings! };
    expect(projectIn(link(project))).toEqual(project);
  });

  it('says what is wrong with a robot that cannot be', () => {
    const project = measuredProject();
    const { myRobot } = project.settings!;
    const impossible = {
      ...myRobot!,
      traits: { ...myRobot!.traits, motors: { ...myRobot!.traits.motors, charge: 9 } },
    };
    const read = projectOfLink(link({ ...project, settings: { ...project.settings!, myRobot: impossible } }), courses);
    expect('problem' in read && read.problem.message).toContain(
      'settings.myRobot.traits.motors.charge: 9 is not within 0.5 … 1.5.',
    );
  });
});

describe('the picture of a task in a link', () => {
  const project = taskProject();
  const withPicture = (bytes: number): Project => {
    const { task } = project.scene;
    const card = { ...sceneDefaults.card, ...task.card, picture: `data:image/png;base64,${noiseOf(bytes)}` };
    return { ...project, scene: { ...project.scene, task: { ...task, card } } };
  };

  it('comes along as long as the link has at most 8,000 characters, and then stays behind', () => {
    const small = linkOf(withPicture(3_000), { courses, program: true });
    expect(small?.omitted).toEqual([]);
    expect(projectIn(small?.fragment ?? '')).toEqual(withPicture(3_000));
    const large = linkOf(withPicture(90_000), { courses, program: true });
    expect(large?.omitted).toEqual(['task-picture']);
    expect(projectIn(large?.fragment ?? '')).toEqual({
      ...project,
      scene: { ...project.scene, task: { ...project.scene.task, card: { ...project.scene.task.card, picture: '' } } },
    });
  });
});

const noiseOf = (bytes: number): string => {
  const rng = createRng(5);
  return Buffer.from(Uint8Array.from({ length: bytes }, () => rng.u32() & 255)).toString('base64');
};

describe('a link of version 5', () => {
  const kept = keptLink(5);

  it('opens as it always did, with all devices', () => {
    expect(projectIn(kept)).toEqual(devicesProject());
  });

  it('is still made so, and only for several devices', () => {
    expect(link(devicesProject())).toBe(kept);
    const { devices, ...alone } = devicesProject();
    expect(devices?.others).toHaveLength(2);
    expect(link(alone)).toMatch(/^p=2\./);
  });

  it('leaves each device an empty program, or that of another device, without the programs', () => {
    const read = projectIn(link(devicesProject(), false));
    expect(read?.devices?.others.map(({ files, sameAs }) => [files[0]?.text, sameAs])).toEqual([
      ['', ''],
      [undefined, 'Fernbedienung'],
    ]);
  });
});

describe('a link of version 6', () => {
  const kept = keptLink(6);

  it('opens as it always did, each start at its place among the things of the course', () => {
    expect(projectIn(kept)).toEqual(startsProject());
  });

  it('is still made so, and only for a course with starts or a task for several robots', () => {
    expect(link(startsProject())).toBe(kept);
    const project = devicesProject();
    const shared = { ...project.scene, task: { ...project.scene.task, robots: 'all' as const } };
    expect(link({ ...project, scene: shared })).toMatch(/^p=6\./);
    expect(link(devicesProject())).toMatch(/^p=5\./);
  });

  it('names a ready course with starts, and tells where they were changed since', () => {
    const project = { ...startsProject(), course: 'chase' };
    const { scene } = project;
    const made = linkOf(project, { courses: () => scene, program: true })?.fragment ?? '';
    expect(made.length).toBeLessThan(link(project).length);
    expect(projectOfLink(made, () => scene)).toMatchObject({ isCourseChanged: false, project: { scene } });
    const moved = { ...scene, objects: scene.objects.filter(({ id }) => id !== 'r2') };
    expect(projectOfLink(made, () => moved)).toMatchObject({ isCourseChanged: true });
  });
});

describe('a link of version 7', () => {
  const kept = keptLink(7);

  it('opens with every shape, lock, group and foe', () => {
    expect(projectIn(kept)).toEqual(shapesProject());
  });

  it('is still made so, and only for a course that has what is new', () => {
    expect(link(shapesProject())).toBe(kept);
    const { scene, ...project } = shapesProject();
    const plain = scene.objects.filter(({ lock, group, type }) => !lock && group === undefined && type !== 'mover');
    expect(link({ ...project, scene: { ...scene, objects: plain } })).toMatch(/^p=6\./);
    const alone = scene.objects.filter(({ id }) => id === 'rund-2').map((object) => ({ ...object, angle: 90 }));
    const read = projectIn(link({ ...project, scene: { ...scene, objects: alone } }));
    expect(read?.scene.objects).toEqual([
      { type: 'block', id: 'rund-2', at: [300, 600], size: [80, 60], angle: 90, round: true },
    ]);
  });

  it('names a ready course with a polygon, and tells where it was changed since', () => {
    const { scene, ...project } = shapesProject();
    const made =
      linkOf({ ...project, scene, course: 'shapes' }, { courses: () => scene, program: true })?.fragment ?? '';
    expect(projectOfLink(made, () => scene)).toMatchObject({ isCourseChanged: false, project: { scene } });
    const turned = scene.objects.map((object) => ('corners' in object ? { ...object, angle: 1 } : object));
    expect(projectOfLink(made, () => ({ ...scene, objects: turned }))).toMatchObject({ isCourseChanged: true });
  });
});

describe('a link of version 8', () => {
  const kept = keptLink(8);
  const named = (): Project => {
    const { scene, ...project } = startsProject();
    return { ...project, scene: { ...scene, robot: { ...scene.robot, name: 'Ada', color: 'teal' } } };
  };

  it('opens with the name and the colour of the first robot', () => {
    expect(projectIn(kept)).toEqual(named());
  });

  it('is still made so, and only for a course that has one of them', () => {
    expect(link(named())).toBe(kept);
    const { scene, ...project } = named();
    const { name: _, color: __, ...robot } = scene.robot;
    const { name: ___, ...colored } = scene.robot;
    expect(link({ ...project, scene: { ...scene, robot } })).toMatch(/^p=6\./);
    expect(projectIn(link({ ...project, scene: { ...scene, robot: colored } }))?.scene.robot).toEqual(colored);
  });

  it('names a ready course with them, and tells where they were changed since', () => {
    const { scene, ...project } = named();
    const made = linkOf({ ...project, scene, course: 'chase' }, { courses: () => scene, program: true });
    const other = { ...scene, robot: { ...scene.robot, color: 'pink' as const } };
    expect(projectOfLink(made?.fragment ?? '', () => scene)).toMatchObject({ isCourseChanged: false });
    expect(projectOfLink(made?.fragment ?? '', () => other)).toMatchObject({ isCourseChanged: true });
  });
});

describe('a link of version 9', () => {
  const kept = keptLink(9);

  it('opens with the data of a task, and of what is handed in', () => {
    expect(projectIn(kept)).toEqual(classProject());
    expect(projectIn(link(handedInProject()))).toEqual(handedInProject());
  });

  it('is still made so, and only for these', () => {
    expect(link(classProject())).toBe(kept);
    expect(link(handedInProject())).toMatch(/^p=9\./);
    expect(link(taskProject())).toMatch(/^p=3\./);
  });

  it('whose data is no object holds no project', () => {
    const project = { ...taskProject(), task: [] as unknown as Record<string, unknown> };
    expect(codeOf(projectOfLink(link(project), courses))).toBe('invalid');
  });
});

describe('a link of version 10', () => {
  const kept = keptLink(10);

  it('opens with the heights of its things, each at its place', () => {
    expect(projectIn(kept)).toEqual(heightsProject());
  });

  it('is still made so, and only for a course in which a thing has a height of its own', () => {
    expect(link(heightsProject())).toBe(kept);
    expect(link(shapesProject())).toBe(keptLink(7));
  });

  it('takes 20 letters more for thirty walls that are 30 mm high', () => {
    const { scene, ...project } = taskProject();
    const walls = Array.from({ length: 30 }, (_, index): SceneObject => {
      const x = 30 * index;
      return { type: 'wall', id: `wall-${String(index + 1)}`, from: [x, 100], to: [x, 300], thickness: 10 };
    });
    const of = (objects: readonly SceneObject[]): string => link({ ...project, scene: { ...scene, objects } });
    const low = of(walls.map((wall) => ({ ...wall, height: 30 })));
    expect(low).toMatch(/^p=10\./);
    expect(low.length - of(walls).length).toBeLessThanOrEqual(20);
  });

  it('names a ready course with them, and tells where they were changed since', () => {
    const { scene, ...project } = heightsProject();
    const made = linkOf({ ...project, scene, course: 'low' }, { courses: () => scene, program: true });
    expect(projectOfLink(made?.fragment ?? '', () => scene)).toMatchObject({ isCourseChanged: false });
    const other = shapesProject().scene;
    expect(projectOfLink(made?.fragment ?? '', () => other)).toMatchObject({ isCourseChanged: true });
  });
});

describe('a link of version 11', () => {
  const kept = keptLink(11);

  it('opens with the colours of its fields and things, and with its sheets, each at its place', () => {
    expect(projectIn(kept)).toEqual(coloursProject());
  });

  it('is still made so, and only for a course with something of that', () => {
    expect(link(coloursProject())).toBe(kept);
    expect(link(heightsProject())).toBe(keptLink(10));
  });

  it('takes 60 letters more for thirty blocks that are red', () => {
    const { scene, ...project } = taskProject();
    const blocks = Array.from({ length: 30 }, (_, index): Block => {
      return { type: 'block', id: `block-${String(index + 1)}`, at: [30 * index, 100], size: [40, 40], angle: 0 };
    });
    const of = (objects: readonly SceneObject[]): string => link({ ...project, scene: { ...scene, objects } });
    const red = of(blocks.map((block) => ({ ...block, color: 'red' as const })));
    expect(red).toMatch(/^p=11\./);
    expect(red.length - of(blocks).length).toBeLessThanOrEqual(60);
  });

  it('names a ready course with them, and tells where they were changed since', () => {
    const { scene, ...project } = coloursProject();
    const made = linkOf({ ...project, scene, course: 'colours' }, { courses: () => scene, program: true });
    expect(projectOfLink(made?.fragment ?? '', () => scene)).toMatchObject({ isCourseChanged: false });
    const other = heightsProject().scene;
    expect(projectOfLink(made?.fragment ?? '', () => other)).toMatchObject({ isCourseChanged: true });
  });

  it.each(['no JSON', '[]', '{"objects":[[-1,{}]]}', '{"objects":[[0,7]]}', '{"course":7}'])(
    'whose news are %s is damaged',
    (news) => {
      const { task, ...whole } = ready;
      const { seconds, noTouch } = task;
      const out = new ModelWriter();
      const content = { files: [], course: null, settings: null, scene: { whole: { ...whole, task: { seconds, noTouch } } }, extras: {}, myRobot: '', devices: null, starts: [], sharing: null, additions: [], firstRobot: null, carried: '', heights: [], news }; // prettier-ignore
      laterVersions[11].modelled.codec.write(out, content);
      const bytes = Uint8Array.from([2, ...out.bytes()]);
      expect(codeOf(projectOfLink(linkOfBytes({ version: 11, bytes }), courses))).toBe('damaged');
    },
  );
});

function keptLink(version: number): string {
  return readFileSync(new URL(`kept/link-v${String(version)}.txt`, import.meta.url), 'utf8').trim();
}
