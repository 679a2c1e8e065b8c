package particles;

import deSolvers.DEStateSource;

/** A system behind the simple interface: without its arrays, its order and what it knows of its derivatives. */
class PlainSource implements DEStateSource {
    private final ParticleSystem system;

    PlainSource(ParticleSystem system) {
        this.system = system;
    }

    @Override
    public int getStateSize() {
        return system.getStateSize();
    }

    @Override
    public void getState(double[] state) {
        system.getState(state);
    }

    @Override
    public void setState(double[] state) {
        system.setState(state);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        system.getStateDerivative(dSdt);
    }

    @Override
    public double getTime() {
        return system.getTime();
    }

    @Override
    public void incTime(double deltaT) {
        system.incTime(deltaT);
    }
}
