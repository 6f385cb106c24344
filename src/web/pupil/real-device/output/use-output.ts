import { useLayout } from '../../../session/layout/parts';

/** Leads to the output of the board at the cable, which stands in the console. */
export function useOutput(): () => void {
  const { layout } = useLayout();
  return () => {
    layout.tab.value = 'console';
  };
}
