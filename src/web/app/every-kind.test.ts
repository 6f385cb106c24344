import { readdirSync, readFileSync } from 'node:fs';
import { afterAll, beforeAll, describe, expect, expectTypeOf, it } from 'vitest';

import { LANGUAGES } from '#core/languages';
import { distanceTo, editorKinds, fieldsOf, kindOf, middleOf, movedBy, newObject, placeOf } from '#editor/kinds/index';
import type { EditorKind } from '#editor/kinds/kind';
import { withField } from '#editor/object-edits';
import { usualToolOptions } from '#editor/tools/tool-options';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { inverse } from '#scene/inverse';
import { boundsOf, reachesInto, sceneKinds, solidParts } from '#scene/kinds/index';
import type { AnyObject, SceneKind } from '#scene/kinds/kind';
import { kindReaders } from '#scene/kinds/reading/index';
import type { KindReader } from '#scene/kinds/reading/kind-reader';
import { readId, readPlace } from '#scene/kinds/reading/unread';
import { isNewKind } from '#scene/news';
import { parseScene } from '#scene/parse';
import { defaultScene, type Point, type Scene, type SceneObject } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { pendingChanges } from '#simulation/at-once';
import { CourseWorld } from '#simulation/course/course-world';
import { linkKinds, linkOrder, type SharedByKinds } from '#project/link/scene-codec';
import { constant, record } from '#project/link/codec';
import { courseShapes } from '#picture/course';
import { pictureKinds } from '#picture/kinds/index';
import type { PictureKind } from '#picture/kinds/kind';
import { circle } from '#picture/shapes';
import { svgOf } from '#picture/svg';
import { builds } from '#simulation/course/bodies';
import { changesInRun, isLasting } from '#simulation/kinds';

import { drawObject } from '../pupil/arena/picture/draw-object';
import { lightPalette } from '../pupil/arena/model/palette';
import { fitView } from '../pupil/arena/view/view-transform';
import kindNames from '../course/editor/words/kinds';
import { kindWords, namesOf, whereText } from '../course/editor/words/object-words';
import { setLanguage } from '../kit/i18n';
import { coursePdf } from '../teacher/print/pdf-course';
import { planPrint } from '../teacher/print/print-plan';

/** A kind that no course has: a puddle on the floor. All that a new kind needs, in the shape of the tables. */
interface Puddle extends AnyObject {
  readonly type: 'puddle';
  readonly at: Point;
  readonly radius: number;
}
const around = ({ at: [x, y], radius }: Puddle) => ({
  ...{ minX: x - radius, minY: y - radius, maxX: x + radius, maxY: y + radius },
});
const inScene: SceneKind<Puddle> = {
  name: 'puddle',
  write: ({ at, radius }) => [`"at": [${at.join(', ')}]`, `"radius": ${String(radius)}`],
  solid: () => [],
  bounds: around,
  reachesInto: () => true,
};
const inReading: KindReader<Puddle> = {
  properties: ['at', 'radius'],
  read: (given) => ({
    type: 'puddle',
    id: readId(given),
    at: readPlace(given, 'at'),
    radius: given.reader.whole(...given.at('radius'), { min: 1, max: 500 }),
  }),
};
const inEditor: EditorKind<Puddle> = {
  layer: 0,
  place: ({ at }) => at,
  span: () => null,
  middle: ({ at: [x, y] }) => ({ x, y }),
  extentMm: ({ radius }) => 2 * radius,
  distanceMm: ({ at: [x, y], radius }, place) => Math.max(0, Math.hypot(place.x - x, place.y - y) - radius),
  meets: () => true,
  moved: (puddle, dx, dy) => ({ ...puddle, at: [puddle.at[0] + dx, puddle.at[1] + dy] }),
  turned: (puddle) => puddle,
  mirrored: (puddle) => puddle,
  scaled: (puddle) => puddle,
  handles: () => [],
  fields: (puddle) => [
    {
      ...{ kind: 'number', name: 'length', value: puddle.radius, min: 1, max: 500, step: 1, unit: 'mm' },
      with: (radius: number) => ({ ...puddle, radius }),
    },
  ],
  made: (id, at) => ({ type: 'puddle', id, at, radius: 40 }),
};
const inPicture: PictureKind<Puddle> = {
  ground: ({ at, radius }, { colors }) => [circle(radius, { fill: colors.target }, at)],
  paper: ({ at, radius }) => [circle(radius, { stroke: '#000000', width: 1 }, at)],
  frame: () => null,
};
const inLink = ({ columns, id, place }: SharedByKinds) =>
  record<Puddle>({ type: constant('puddle'), id, at: place, radius: columns.uint() });
const called = { de: 'Pfütze', fr: 'Flaque', it: 'Pozzanghera', en: 'Puddle' };
const inWords = { where: ({ at }: Puddle) => at.join(' | ') };

/** The tables, and what the made-up kind is in each. */
const tables: readonly (readonly [table: object, madeUp: unknown])[] = [
  [sceneKinds, inScene],
  [kindReaders, inReading],
  [editorKinds, inEditor],
  [changesInRun, 'shown'],
  [builds, null],
  [linkKinds, inLink],
  [pictureKinds, inPicture],
  [kindWords, inWords],
  [kindNames, { one: called, many: called }],
];
const types = [...Object.keys(sceneKinds), 'puddle'] as SceneObject['type'][];

/** Counts what is drawn. */
function counting() {
  let count = 0;
  const target = () => (count++, { width: 1 });
  const context = new Proxy({}, { get: () => target, set: () => true }) as CanvasRenderingContext2D;
  return { context, count: () => count };
}

beforeAll(async () => {
  for (const [table, madeUp] of tables) Object.assign(table, { puddle: madeUp });
  linkOrder.push('puddle' as (typeof linkOrder)[number]);
  globalThis.document ??= { documentElement: {} } as Document;
  globalThis.Path2D ??= class {
    moveTo(): void {}
    lineTo(): void {}
    rect(): void {}
    roundRect(): void {}
    addPath(): void {}
    arc(): void {}
    closePath(): void {}
  } as unknown as typeof Path2D;
  await setLanguage('en');
});
afterAll(() => {
  for (const [table] of tables) Reflect.deleteProperty(table, 'puddle');
  linkOrder.pop();
});

describe.each(types)('the kind %s', (type) => {
  const empty = defaultScene();
  const made = (): SceneObject => {
    const object = newObject(empty, type, [300, 300], usualToolOptions);
    if (!object) throw new Error(`No ${type} could be made.`);
    return object;
  };
  const courseOf = (object: SceneObject): Scene => ({ ...empty, objects: [object] });

  it('stands in every table', () => {
    for (const [table] of tables)
      // Starts and newer kinds stand apart in a link, after all that was there before them.
      if ((type !== 'start' && !isNewKind(made())) || table !== linkKinds) expect(Object.keys(table)).toContain(type);
  });

  it('comes back from its file as it was', () => {
    const course = courseOf(made());
    expect(parseScene(serializeScene(course))).toEqual({ scene: course });
    expect(parseScene(serializeScene(course).replace('"id"', '"what": 1, "id"'))).toMatchObject({
      problems: [{ code: 'unknown-property' }],
    });
  });

  it('comes back from a link as it was', async () => {
    const { linkOf, projectOfLink } = await import('#project/link/link'); // it makes its codecs of the tables once
    const course = courseOf(made());
    const project = { files: [], scene: course, course: null };
    const link = linkOf(project, { courses: () => null, program: false });
    expect(projectOfLink(link?.fragment ?? '', () => null)).toMatchObject({ project: { scene: course } });
  });

  it('is put in, moved and taken away as edits, each of which can be taken back', () => {
    const object = made();
    const other = { ...made(), id: 'other' };
    const course = courseOf(object);
    const edits: readonly SceneEdit[] = [
      { type: 'add', objects: [other] },
      { type: 'remove', ids: [object.id] },
      { type: 'replace', changes: [{ id: object.id, by: [movedBy(object, 10, -20)] }] },
      { type: 'replace', changes: [{ id: object.id, by: [object, movedBy(other, 50, 0)] }] },
    ];
    for (const edit of edits) {
      const after = applyEdit(course, edit);
      expect(after).not.toEqual(course);
      expect(applyEdit(after, inverse(course, edit))).toEqual(course);
    }
  });

  it('has its bounds around it and its outline in them', () => {
    const object = made();
    const { minX, minY, maxX, maxY } = boundsOf(object);
    expect([minX < maxX, minY < maxY || type === 'wall', reachesInto(object, empty.size)]).toEqual([true, true, true]);
    for (const { x, y } of solidParts(object).flat())
      expect([x >= minX, x <= maxX, y >= minY, y <= maxY]).toEqual([true, true, true, true]);
  });

  it('is hit, moved and turned, and comes back', () => {
    const object = made();
    expect(distanceTo(object, middleOf(object), 0)).toBe(0);
    expect(placeOf(movedBy(object, 10, -20))).toEqual([placeOf(object)[0] + 10, placeOf(object)[1] - 20]);
    expect(movedBy(movedBy(object, 10, -20), -10, 20)).toEqual(object);
    let turned = object;
    for (let tap = 0; tap < 8; tap += 1) turned = kindOf(turned).turned(turned, middleOf(turned), 45);
    expect(turned).toEqual(object);
    for (const { at, id } of kindOf(object).handles(object, 10))
      expect([Number.isFinite(at.x), Number.isFinite(at.y), id]).toEqual([true, true, object.id]);
  });

  it('takes each of its fields from the list, as an edit', () => {
    const course = courseOf(made());
    const [object] = course.objects;
    for (const field of object ? fieldsOf(object) : []) {
      const value = field.kind === 'number' ? field.value + field.step : field.kind === 'switch' ? !field.value : 'x';
      const other = field.kind === 'choice' ? field.choices.find((choice) => choice !== field.value) : value;
      const edit = withField(course, object?.id ?? '', field.name, other ?? value);
      const [after] = edit ? applyEdit(course, edit).objects : [];
      expect(after && fieldsOf(after).find(({ name }) => name === field.name)?.value).toBe(other);
    }
  });

  it('is in the world of a run, at once or with the next start', () => {
    const object = made();
    const world = new CourseWorld(empty);
    world.take(courseOf(object));
    world.take(empty);
    expect(() => new CourseWorld(courseOf(object))).not.toThrow();
    expect(pendingChanges(empty, courseOf(object)).coming).toEqual(isLasting(object) ? [object] : []);
  });

  it('is printed on paper, true to scale or as the outline of what stands there', () => {
    const pdf = (course: Scene): string => {
      const plan = planPrint(course.size, 'exact');
      if ('problem' in plan) throw new Error(plan.problem);
      const words = { name: '', planTitle: '', steps: [] };
      return coursePdf(course, plan, { outlines: true, background: null, isCompressed: false }, words).output();
    };
    expect(pdf(courseOf(made())).length).toBeGreaterThan(pdf(empty).length);
  });

  it('is drawn and printed', () => {
    const drawn = counting();
    drawObject(drawn.context, fitView(empty.size, { widthPx: 800, heightPx: 600 }), made(), lightPalette);
    expect(drawn.count()).toBeGreaterThan(0);
    const shapes = courseShapes([made()], { colors: lightPalette, px: 1, seconds: String });
    expect(svgOf(shapes, (at) => at)).toMatch(/^<.*>$/s);
  });

  it('has words in every language', async () => {
    for (const language of LANGUAGES) {
      await setLanguage(language);
      const course = courseOf(made());
      expect(namesOf(course).get(made().id)).not.toBe('');
      expect(whereText(made())).not.toBe('');
      expect(kindNames[type].many[language]).not.toBe('');
    }
    await setLanguage('en');
  });
});

describe('the tables of kinds', () => {
  it('want every kind: the compiler asks for a missing one', () => {
    type Type = SceneObject['type'];
    expectTypeOf<keyof typeof sceneKinds>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof kindReaders>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof editorKinds>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof changesInRun>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof builds>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof pictureKinds>().toEqualTypeOf<Type>();
    expectTypeOf<keyof typeof kindWords>().toEqualTypeOf<Type>();
  });

  it('are all those that docs/architecture.md names, and no others', () => {
    const src = new URL('../../', import.meta.url);
    const files = readdirSync(src, { recursive: true, encoding: 'utf8' }).filter(
      (file) => /\.(ts|vue)$/.test(file) && !/\.test\.ts$/.test(file),
    );
    const found = files.filter((file) =>
      /Record<(Scene|Link)Object\['type'\]/.test(readFileSync(new URL(file.replaceAll('\\', '/'), src), 'utf8')),
    );
    const row = readFileSync(new URL('../docs/architecture.md', src), 'utf8')
      .split('\n')
      .find((line) => line.startsWith('| kind of object'));
    const named = [...(row ?? '').matchAll(/`src\/([^`]*)`/g)].map(([, path = '']) => path);
    for (const file of found) expect(named).toContain(file.replaceAll('\\', '/').replace(/\/index\.ts$/, ''));
    for (const path of named)
      expect(path === 'scene/scene.ts' || found.some((file) => file.startsWith(path))).toBe(true);
  });
});
