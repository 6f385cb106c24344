import { ref, shallowRef } from 'vue';
import { createVuetify, type LocaleInstance, type ThemeDefinition } from 'vuetify';
import { VSvgIcon } from 'vuetify/components/VIcon';

/** Vuetify's own colours, taken from the same palette as `styles/tokens.css`. */
const light: ThemeDefinition = {
  dark: false,
  colors: {
    background: '#eceef1',
    surface: '#ffffff',
    primary: '#b24700',
    error: '#c3262b',
    info: '#1459b3',
    success: '#1b7a3a',
    warning: '#7a5200',
  },
};
const dark: ThemeDefinition = {
  dark: true,
  colors: {
    background: '#101317',
    surface: '#1a1e23',
    primary: '#ffb066',
    error: '#ff8a84',
    info: '#86b9ff',
    success: '#5fcb86',
    warning: '#f5c04a',
  },
};

/** None of what our templates use has words or numbers of its own: those come from `src/web/page/i18n`. */
const locale: LocaleInstance = {
  name: 'none',
  messages: ref({}),
  current: shallowRef('de'),
  fallback: shallowRef('de'),
  decimalSeparator: shallowRef('.'),
  numericGroupSeparator: shallowRef('’'),
  t: (key) => key,
  n: (value) => String(value),
  provide: () => locale,
};

/** The app's Vuetify: only what its templates use is bundled. Icons come as paths; none of Vuetify's own is ever shown. */
export const vuetify = createVuetify({
  locale: { adapter: locale },
  theme: { defaultTheme: 'light', themes: { light, dark } },
  icons: { defaultSet: 'mdi', aliases: {}, sets: { mdi: { component: VSvgIcon } } },
  defaults: {
    // Menus open inside a landmark of the page, so that screen readers find them there.
    VMenu: { attach: '#menus', offset: 6, transition: 'fade-transition' },
    VListItem: { ripple: false },
    VDialog: { transition: 'fade-transition' },
  },
});
