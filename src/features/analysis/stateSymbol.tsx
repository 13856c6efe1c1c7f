import { MathSymbol } from '../../ui/kit/symbol.tsx';
import type { StateName } from './names.ts';

export function StateSymbol({ state, name }: { state: StateName | undefined; name: string }) {
  return <MathSymbol of={state?.symbol ?? name} rate={state?.rate} />;
}
