#!/usr/bin/env python3
"""Prints the references of the <test type="ttest"> blocks beside it:  assets/tests/references.py

Luminances of directional albedos, by closed forms and, for microfacets, by the midpoint rule over the facets'
normals h, in double precision; doubling its points moves none by more than 1e-5. Formulas from the literature that
the shaders name, not from the shaders.
"""
import cmath
import math

POINTS = 600


def luminance(r, g, b):
    return 0.212671 * r + 0.715160 * g + 0.072169 * b


def fresnel(cos_i, eta):
    """Unpolarised reflectance, by amplitudes with a complex eta (dielectrics: real)."""
    cos_t = cmath.sqrt(1 - (1 - cos_i * cos_i) / (eta * eta))
    rs = (cos_i - eta * cos_t) / (cos_i + eta * cos_t)
    rp = (eta * cos_i - cos_t) / (eta * cos_i + cos_t)
    return (abs(rs) ** 2 + abs(rp) ** 2) / 2


def metal(cos_i, eta, k):
    return luminance(*(fresnel(cos_i, complex(n, e)) for n, e in zip(eta, k)))


def phong_1(angle):
    """Of the lobe alone, for n = 1: the clamped cosines about r and n, multiplied and integrated."""
    return (math.sin(angle) + (math.pi - angle) * math.cos(angle)) / math.pi


def phong_0(angle):
    """For n = 0: the cosine over what is above the surface and in the lobe's hemisphere."""
    return (1 + math.cos(angle)) / 2


def smith_lambda(beckmann, alpha, z):
    tangent = math.sqrt(max(1 - z * z, 0)) / abs(z)
    if tangent == 0:
        return 0
    if not beckmann:
        return (math.sqrt(1 + (alpha * tangent) ** 2) - 1) / 2
    a = 1 / (alpha * tangent)
    return (math.exp(-a * a) / (a * math.sqrt(math.pi)) - math.erfc(a)) / 2


def fit_g1(alpha, z):
    tangent = math.sqrt(max(1 - z * z, 0)) / z
    b = 1 / (alpha * tangent) if tangent > 0 else 10
    return 1 if b >= 1.6 else (3.535 * b + 2.181 * b * b) / (1 + 2.276 * b + 2.577 * b * b)


def over_facets(beckmann, alpha, angle, value):
    """Integral of D(h) (wo.h) / zo value(wo, h, wo.h) over the normals that face wo."""
    wo = (math.sin(angle), 0.0, math.cos(angle))
    total = 0.0
    for i in range(POINTS):
        s = (i + 0.5) / POINTS  # 1 - s^2 is the distribution function of the normals' slopes
        tangent2 = alpha * alpha * (-2 * math.log(s) if beckmann else (1 - s * s) / (s * s))
        hz = 1 / math.sqrt(1 + tangent2)
        across = math.sqrt(tangent2) * hz
        for j in range(POINTS):
            phi = math.pi * (j + 0.5) / POINTS  # the other half is its mirror image
            h = (across * math.cos(phi), across * math.sin(phi), hz)
            cos_h = wo[0] * h[0] + wo[2] * h[2]
            if cos_h > 0:
                total += 2 * s * cos_h / (hz * wo[2]) * value(wo, h, cos_h)
    return total / POINTS**2


def reflected(wo, h, cos_h):
    return 2 * cos_h * h[2] - wo[2]


def coat(alpha, eta, angle):
    """Nori's microfacet lobe for ks = 1."""
    def value(wo, h, cos_h):
        zi = reflected(wo, h, cos_h)
        return fresnel(cos_h, eta) * fit_g1(alpha, wo[2]) * fit_g1(alpha, zi) if zi > 0 else 0
    return over_facets(True, alpha, angle, value)


def smith_g2(beckmann, alpha, zo, zi):
    return 1 / (1 + smith_lambda(beckmann, alpha, zo) + smith_lambda(beckmann, alpha, zi))


def rough_metal(beckmann, alpha, eta, k, angle):
    def value(wo, h, cos_h):
        zi = reflected(wo, h, cos_h)
        return metal(cos_h, eta, k) * smith_g2(beckmann, alpha, wo[2], zi) if zi > 0 else 0
    return over_facets(beckmann, alpha, angle, value)


def rough_glass(beckmann, alpha, eta, angle):
    def value(wo, h, cos_h):
        share = fresnel(cos_h, eta)
        zi = reflected(wo, h, cos_h)
        through = 0
        sin2 = (1 - cos_h * cos_h) / (eta * eta)
        if sin2 < 1:
            cos_t = math.sqrt(1 - sin2)
            zt = h[2] * (cos_h / eta - cos_t) - wo[2] / eta
            through = (1 - share) * smith_g2(beckmann, alpha, wo[2], zt) if zt < 0 else 0
        return through + (share * smith_g2(beckmann, alpha, wo[2], zi) if zi > 0 else 0)
    return over_facets(beckmann, alpha, angle, value)


def square_irradiance(half, height):
    """Of a point below the middle of a square of radiance 1 that is parallel to the surface, over pi."""
    a = half / height
    root = math.sqrt(1 + a * a)
    return 4 / (2 * math.pi) * 2 * (a / root) * math.atan(a / root)


def show(name, angles, reference):
    print(f"{name}: " + ", ".join(f"{reference(math.radians(a)):.6f}" for a in angles))


def main():
    copper = ((0.2, 0.92, 1.1), (3.9, 2.45, 2.14))
    print(f"diffuse 0.2 0.5 0.9: {luminance(.2, .5, .9):.6f}")
    print(f"mirror 0.9 0.6 0.3: {luminance(.9, .6, .3):.6f}")
    show("phong n 1, kd 0.3, ks 0.6", (0, 30, 60, 85), lambda t: .3 + .6 * phong_1(t))
    show("phong n 0, kd 0, ks 0.8", (0, 30, 60, 85), lambda t: .8 * phong_0(t))
    show("conductor", (0, 30, 60, 85), lambda t: metal(math.cos(t), *copper))
    show("microfacet alpha 0.3, kd 0.4", (5, 40, 75), lambda t: .4 + .6 * coat(.3, 1.5046 / 1.000277, t))
    show("microfacet alpha 0.1, kd 0", (5, 40, 75), lambda t: coat(.1, 1.5046 / 1.000277, t))
    show("roughconductor ggx 0.3", (5, 40, 75), lambda t: rough_metal(False, .3, *copper, t))
    show("roughconductor beckmann 0.5", (5, 40, 75), lambda t: rough_metal(True, .5, *copper, t))
    show("roughdielectric ggx 0.3, 1.5", (5, 40, 75), lambda t: rough_glass(False, .3, 1.5, t))
    show("roughdielectric ggx 0.3, from inside", (5, 40, 75), lambda t: rough_glass(False, .3, 1 / 1.5, t))
    show("roughdielectric beckmann 0.2, 1.5", (5, 40, 75), lambda t: rough_glass(True, .2, 1.5, t))
    print(f"square of 2 x 2, radiance 3, at 2 above albedo 0.5: {.5 * 3 * square_irradiance(1, 2):.6f}")
    glass = fresnel(1, 1.5)
    print(f"glass of index 1.5 before a radiance of 2: {2 * (1 - glass) / (1 + glass):.6f}")


if __name__ == "__main__":
    main()
