import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

/** What a gallery shows: all robots or one, all courses or one, the missions for a robot, the measuring of one's own, the checking of a class, the making of a task or a series, a series. */
export type GalleryPage =
  | { readonly kind: 'all' }
  | { readonly kind: 'robot'; readonly robot: string }
  | { readonly kind: 'courses' }
  | { readonly kind: 'course'; readonly course: string }
  | { readonly kind: 'missions'; readonly robot: string | null }
  /** `from`: the address behind `#`, which holds it, says where it is, or names one that this browser keeps. */
  | { readonly kind: 'series'; readonly from: string }
  | { readonly kind: (typeof PAGES)[number] };

/**
 * Which gallery is open, and where: that of the robots, of the courses or of the missions. Their pages have addresses
 * (`#robots`, `#robots/callibot`, `#courses`, `#courses/slalom`, `#missions`, `#missions/callibot`, `#my-robot`, `#class`, `#task`,
 * `#make-series`, and `#s=…`, `#series=…`, `#series/…` for a series of tasks): teachers can hand them on, and the browser's back
 * button leads back.
 */
export interface GalleryModel {
  /** `null`: closed. */
  readonly page: Readonly<ShallowRef<GalleryPage | null>>;
  /** Opens the page of a robot, or all robots. */
  open(robot?: string): void;
  /** Opens the page of a course, or all courses. */
  openCourses(course?: string): void;
  /** The page of a course becomes that of another: the back button leads past it. */
  replaceCourse(course: string): void;
  /** Opens the missions for a robot, or for the one that is on the table. */
  openMissions(robot?: string): void;
  /** Those for another robot in the same place: the back button leads past them. */
  replaceMissions(robot: string): void;
  /** Opens a series of tasks that this browser keeps. */
  openSeries(id: string): void;
  /** Opens the page on which the pupil's own robot is measured, or that on which a task or a series is made, or hand-ins of a class are checked. */
  openPage(page: (typeof PAGES)[number]): void;
  close(): void;
}

const ROBOTS = 'robots';
const COURSES = 'courses';
const MISSIONS = 'missions';
/** Those that have one page each. */
const PAGES = ['my-robot', 'class', 'task', 'make-series'] as const;
/** Under this name the browser's history keeps how many pages were opened. */
const DEPTH = 'galleryPages';

/** What a page's address asks for: the part behind `#`. A course is known by what people write from memory, too. */
export function galleryPage(hash: string): GalleryPage | null {
  if (/^#s(eries[=/]|=)./.test(hash)) return { kind: 'series', from: hash.slice(1) };
  const [name, id = '', ...more] = hash
    .replace(/^#/, '')
    .replace(/^courses?[=/]/, 'courses/')
    .split('/');
  if (more.length > 0) return null;
  if (name === ROBOTS) return id === '' ? { kind: 'all' } : { kind: 'robot', robot: id };
  if (name === COURSES) return id === '' ? { kind: 'courses' } : { kind: 'course', course: id };
  const kind = PAGES.find((page) => page === name);
  if (kind) return id === '' ? { kind } : null;
  if (name === MISSIONS) return { kind: 'missions', robot: id === '' ? null : id };
  return null;
}

export function createGallery(): GalleryModel {
  const page = shallowRef(galleryPage(location.hash));
  const began = page.value === null ? null : location.hash;
  /** The page that the visit began with is no longer wanted either. */
  let isLeaving = false;
  const bare = (): void => history.replaceState(null, '', location.pathname + location.search);
  const follow = (): void => {
    isLeaving = false;
    page.value = galleryPage(location.hash);
  };
  const arrive = (): void => {
    if (isLeaving && location.hash === began && page.value === null) bare();
    follow();
  };
  addEventListener('popstate', arrive);
  onScopeDispose(() => removeEventListener('popstate', arrive));
  function go(gallery: string, id?: string): void {
    history.pushState({ [DEPTH]: depth() + 1 }, '', id === undefined ? `#${gallery}` : `#${gallery}/${id}`);
    follow();
  }
  function replace(gallery: string, id: string): void {
    history.replaceState({ [DEPTH]: depth() }, '', `#${gallery}/${id}`);
    follow();
  }
  return {
    page,
    open: (robot) => go(ROBOTS, robot),
    openCourses: (course) => go(COURSES, course),
    openPage: (page) => go(page),
    openSeries: (id) => go('series', id),
    openMissions: (robot) => go(MISSIONS, robot),
    replaceCourse: (course) => replace(COURSES, course),
    replaceMissions: (robot) => replace(MISSIONS, robot),
    close() {
      if (page.value === null) return;
      page.value = null;
      // The pages that were opened from the app leave the history; an address that was followed is only left.
      isLeaving = depth() > 0;
      if (isLeaving) history.go(-depth());
      else bare();
    },
  };
}

/** How many pages of a gallery were opened since the app itself was in sight. */
function depth(): number {
  const state = history.state as Readonly<Record<string, unknown>> | null;
  const value = state?.[DEPTH];
  return typeof value === 'number' ? value : 0;
}
