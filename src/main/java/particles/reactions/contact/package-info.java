/** Contact of one particle with surfaces: the surfaces, contact modes, laws of friction and directions of sliding. */
package particles.reactions.contact;
