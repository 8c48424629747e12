//! The worst inputs in 6,000 to 40,000 states per case, as bits of f64.
//!
//! Every run repeats them beside its own states. Inputs that are exact in f32 are for single precision, the others for
//! double precision.

/// `exp_tiny`: u, b, φ.
pub const EXPONENTIALS: [[u64; 7]; 2] = [
    [
        0x3fe5_36e5_dac5_a89b,
        0x3fe3_ecd8_5521_f77a,
        0xbfda_9a75_d146_7b1f,
        0x3fd8_9eec_d2e2_9d90,
        0xbfc6_eb5d_4d7c_5657,
        0x3fd6_19d9_cf19_f0b6,
        0xc00f_f3fd_ae01_9a90,
    ],
    [
        0xbfe6_d551_8000_0000,
        0x3fe5_6063_6000_0000,
        0x3fcb_095c_c000_0000,
        0xbfde_b52a_8000_0000,
        0xbfdc_4712_8000_0000,
        0xbfcc_9b6b_0000_0000,
        0x4009_8798_a000_0000,
    ],
];

/// `versine_small`: φ.
pub const VERSINES: [[u64; 1]; 2] = [[0xbf10_5539_d189_337b], [0x3f70_27f7_2000_0000]];

/// `arc_less_sine`: φ.
pub const ARCS: [[u64; 1]; 2] = [[0x3e74_45dd_e294_d8fe], [0x3f70_08d9_e000_0000]];

/// `log_tiny`: axis and angle.
pub const TINY: [[u64; 4]; 4] = [
    [
        0xbfea_8010_0c88_ee32,
        0xbfd9_0404_572b_6ab5,
        0xbfd9_b68d_6bcc_4ce4,
        0x3f30_3592_54a7_ae4c,
    ],
    [
        0xbfed_2ea7_ee1e_7e1d,
        0xbfd9_e1c2_55a7_612c,
        0xbfb1_c297_c6cd_225f,
        0x3ea2_22f2_ca78_84c7,
    ],
    [
        0xbfe2_79a7_4000_0000,
        0x3fe2_79a7_4000_0000,
        0x3fe2_79a7_4000_0000,
        0x3fa0_6222_0000_0000,
    ],
    [
        0xbfe7_9a04_c000_0000,
        0xbfc3_a037_2000_0000,
        0xbfe5_0b81_2000_0000,
        0x3f70_dfbd_8000_0000,
    ],
];

/// `log_near_pi`: axis and π − φ.
pub const NEAR_PI: [[u64; 4]; 4] = [
    [
        0x3fa0_7868_965d_3e11,
        0x3fe5_992f_0b3e_3a74,
        0xbfe7_96d6_1ef1_32e7,
        0x3f78_88d2_ed67_0c07,
    ],
    [
        0xbfe8_4ec2_c21c_b14f,
        0xbfb5_cdbc_98bb_e8b7,
        0xbfe4_a1fa_a646_7a7e,
        0x3f39_8041_4edb_ac58,
    ],
    [
        0x3fe2_79a7_4000_0000,
        0x3fe2_79a7_4000_0000,
        0xbfe2_79a7_4000_0000,
        0x3f83_fd02_c000_0000,
    ],
    [
        0x3fe2_64b9_8000_0000,
        0xbfe1_e477_0000_0000,
        0xbfe3_1e80_0000_0000,
        0x0000_0000_0000_0000,
    ],
];

/// `log_drifted_r`: R.
pub const DRIFTED: [[u64; 9]; 2] = [
    [
        0xbf97_f4cd_023b_c2e0,
        0x3fef_f815_310d_6d12,
        0x3fa3_0d55_127c_dd82,
        0xbfb4_3b75_3f2c_3f77,
        0x3fa2_0d27_f730_cdee,
        0xbfef_e144_52a5_c40c,
        0xbfef_e420_7354_a313,
        0xbf9a_e0b9_e565_923b,
        0x3fb4_0065_9525_24cc,
    ],
    [
        0x3fd2_08bc_4000_0000,
        0x3fcb_b6b4_8000_0000,
        0xbfed_e94f_0000_0000,
        0xbfed_e94f_0000_0000,
        0x3fd2_08bc_4000_0000,
        0xbfcb_b6b4_8000_0000,
        0x3fcb_b6b4_8000_0000,
        0x3fed_e94f_0000_0000,
        0x3fd2_08bc_4000_0000,
    ],
];

/// `screw_axis_far`: R and t.
pub const FAR: [[u64; 12]; 2] = [
    [
        0xbfee_d5e6_1391_7e72,
        0x3f99_828e_08ef_5d36,
        0x3fd1_088a_5839_9d2d,
        0x3fc4_bb00_50b7_5cbf,
        0x3feb_1694_06b0_bb5e,
        0x3fe0_3a8a_d9c6_9d9a,
        0xbfcb_3874_7e68_8fe0,
        0x3fe1_0478_9868_1fc3,
        0xbfea_3b49_2a52_9e1b,
        0xc134_70ab_3800_3d31,
        0xc0d4_9f27_6d7a_697d,
        0x4113_3590_0c9a_f4ab,
    ],
    [
        0xbfd0_6250_c000_0000,
        0x3fd9_838d_0000_0000,
        0x3fec_2e41_c000_0000,
        0x3feb_8e23_a000_0000,
        0xbfd4_79e4_0000_0000,
        0x3fd9_4a24_6000_0000,
        0x3fdc_1d32_8000_0000,
        0x3feb_80e5_8000_0000,
        0xbfd0_ba65_c000_0000,
        0xc142_6763_4000_0000,
        0x4159_6479_4000_0000,
        0xc14d_fda4_6000_0000,
    ],
];

/// `isa_slow`: ω and v.
pub const SLOW: [[u64; 6]; 2] = [
    [
        0xab9b_42ea_62cd_51af,
        0x2b93_b2e9_b6d2_7030,
        0xab9a_b013_1e09_930d,
        0x7814_b146_1920_70c8,
        0xf7d8_c1e1_ce3b_26c3,
        0xf7ea_1cfe_5b6f_1ea3,
    ],
    [
        0xb824_efee_c000_0000,
        0x37f0_d370_0000_0000,
        0x37f9_0566_8000_0000,
        0x0000_0000_0000_0000,
        0x8000_0000_0000_0000,
        0x8000_0000_0000_0000,
    ],
];

/// `cardan_gimbal`: sequence, angles, ω.
pub const CARDAN: [[u64; 7]; 4] = [
    [
        0x4010_0000_0000_0000,
        0x4003_dbab_495f_a3be,
        0x3ff9_2213_9c60_ba3a,
        0xbfef_8742_c45b_ca32,
        0xbf86_d238_bda8_8522,
        0xbf75_ef22_6d48_f44c,
        0x3f38_b794_1dac_8710,
    ],
    [
        0x4020_0000_0000_0000,
        0x4001_2625_8000_0000,
        0x4009_21fb_6000_0000,
        0xbff0_2696_6000_0000,
        0x3801_3404_4000_0000,
        0x0000_0000_0000_0000,
        0x0000_0000_0000_0000,
    ],
    [
        0x4018_0000_0000_0000,
        0x4009_21fb_5444_2d18,
        0x4009_1cc5_bf6a_26e5,
        0x4007_e43f_c3c4_dbbb,
        0x4042_3e7b_b546_bcf0,
        0x403c_8701_2176_82b2,
        0xc045_111c_ad26_71b7,
    ],
    [
        0x3ff0_0000_0000_0000,
        0xbfc9_cb26_2000_0000,
        0xc000_137f_2000_0000,
        0xc001_4dbd_0000_0000,
        0xb7c1_9cd0_0000_0000,
        0x37c4_8568_0000_0000,
        0x3786_9180_0000_0000,
    ],
];

/// `slider_crank_dead`: lengths, actuated joint, dead centre, distance from it, rate.
pub const SLIDER_CRANK: [[u64; 6]; 4] = [
    [
        0x3fd1_74c6_ffff_ffff,
        0x3fd1_74c6_ffff_ffff,
        0x0000_0000_0000_0000,
        0xbff9_21fb_5444_2d18,
        0xbec9_c6de_f52b_22c8,
        0x000b_ef31_2000_0000,
    ],
    [
        0x3fef_02f5_c000_0000,
        0x3ff2_75fa_e000_0000,
        0x4008_0000_0000_0000,
        0x0000_0000_0000_0000,
        0x0000_0000_0000_0000,
        0x3ff0_0000_0000_0000,
    ],
    [
        0x3fe9_bc13_6666_6666,
        0x3fe9_bc13_6666_6666,
        0x0000_0000_0000_0000,
        0x3ff9_21fb_5444_2d18,
        0xbce2_7121_255b_efd0,
        0x3ff0_0000_0000_0000,
    ],
    [
        0x3fe2_d013_a000_0000,
        0x3fe2_d013_a000_0000,
        0x0000_0000_0000_0000,
        0x3ff9_21fb_6000_0000,
        0xbd98_209a_2000_0000,
        0x3ff0_0000_0000_0000,
    ],
];

/// `wrist_singular` and `elbow_singular`: q of the arm of six joints.
pub const PUMA: [[u64; 6]; 6] = [
    [
        0xbfa7_e470_0000_0000,
        0xbff2_70ec_6000_0000,
        0x3ff9_e1d3_9a15_217c,
        0xbff0_d4cc_0000_0000,
        0xbfcd_6e05_0000_0000,
        0xc004_32dd_3000_0000,
    ],
    [
        0x4003_4ecc_8000_0000,
        0x3fe3_c6c2_c000_0000,
        0x3ff9_e1d0_8000_0000,
        0xbfc5_8c07_0000_0000,
        0xbfd6_ef76_8000_0000,
        0xc007_f9a4_8000_0000,
    ],
    [
        0x3ffc_fb87_6000_0000,
        0x4004_b000_2000_0000,
        0x4001_4348_0000_0000,
        0xbff9_6ef8_a000_0000,
        0xbf63_08a2_9b72_334a,
        0xc005_b610_f000_0000,
    ],
    [
        0x4007_a692_4000_0000,
        0xc007_acc5_c000_0000,
        0x4002_c229_2000_0000,
        0xc004_0177_8000_0000,
        0xbf57_a2e1_8000_0000,
        0xbfef_b186_0000_0000,
    ],
    [
        0xbfc2_ea0c_0000_0000,
        0x4004_866d_1000_0000,
        0xbfef_0cfb_0000_0000,
        0x3fdf_9198_8000_0000,
        0xbd63_3ef8_208f_1db4,
        0x4007_3e44_c000_0000,
    ],
    [
        0xbfe6_6355_4000_0000,
        0x4003_2cf5_a000_0000,
        0x3ff9_e23e_0000_0000,
        0x4005_b58b_c000_0000,
        0x3ffd_efef_c000_0000,
        0xc001_6c89_0000_0000,
    ],
];

/// The same for the arm of seven joints.
pub const PANDA: [[u64; 7]; 4] = [
    [
        0xbfe6_362e_4000_0000,
        0x3fa4_06b8_0000_0000,
        0x3fd1_5ec1_8000_0000,
        0xbfb0_7f2e_0000_0000,
        0xc005_c798_0000_0000,
        0x0007_9afd_2000_0000,
        0xc006_1b96_b000_0000,
    ],
    [
        0xc003_662c_0000_0000,
        0xbfe3_0254_c000_0000,
        0xbff5_2d13_2000_0000,
        0xbfdd_e35e_2000_0000,
        0x4002_bc83_4000_0000,
        0x3fc7_9718_0000_0000,
        0xbfec_46df_c000_0000,
    ],
    [
        0x3fdf_070a_0000_0000,
        0xc006_2983_d000_0000,
        0xc002_a697_a000_0000,
        0xbfdd_e35e_21c7_a145,
        0xbffb_c1be_a000_0000,
        0x3fe1_e9de_8000_0000,
        0xbffd_6eaa_0000_0000,
    ],
    [
        0x3fe1_7f1b_c000_0000,
        0xbfe4_62ad_c000_0000,
        0xbfe0_d88e_4000_0000,
        0xbfdd_e35e_2000_0000,
        0xbf7e_44a0_0000_0000,
        0x3fe7_8ee1_0000_0000,
        0xbfe7_46f6_c000_0000,
    ],
];

/// The same, damped: q, the wanted velocity, λ.
pub const DAMPED: [[u64; 13]; 2] = [
    [
        0x3fc4_fd7e_0000_0000,
        0xc000_cc5d_e000_0000,
        0x3ff9_d145_5323_b7ff,
        0xbfe6_c420_8000_0000,
        0xc000_8324_3000_0000,
        0xbfd6_8f00_0000_0000,
        0x0001_4251_76ce_2d80,
        0x8009_5862_3e46_d340,
        0x8008_785f_bea3_c340,
        0x8009_8693_f2cd_5f00,
        0x0000_4037_c519_0540,
        0x0009_6996_c316_b080,
        0xbf42_7790_44ef_24d4,
    ],
    [
        0x3fb3_337a_0000_0000,
        0xbfb9_8ccc_0000_0000,
        0x3ff7_0bd5_2000_0000,
        0x3fca_6ec2_0000_0000,
        0x3804_17e3_4000_0000,
        0xc004_df19_8000_0000,
        0x3fc1_a865_4000_0000,
        0xbfc7_2440_6000_0000,
        0x3fc0_edc0_8000_0000,
        0xbfc9_d381_c000_0000,
        0xbfaa_e0f9_4000_0000,
        0xbfbd_3712_a000_0000,
        0x3f5b_b61b_c000_0000,
    ],
];
